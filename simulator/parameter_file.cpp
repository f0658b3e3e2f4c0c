// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/parameter_file.hpp"

#include "simulator/ground/text_file.hpp"
#include "simulator/input_file.hpp"
#include "toolchain/param_tool/settings.hpp"

namespace simulator {

ParameterSettings readParameterFile(const std::string& path) {
    const auto text = wholeFile(path);
    if (!text) throw ParameterFileError(path + ": cannot be read");
    std::vector<param_tool::Finding> findings;
    ParameterSettings settings;
    for (const auto& setting : param_tool::parseSettings(*text, path, findings))
        settings.push_back({setting.name, setting.value});
    std::vector<std::string> errors;
    for (const auto& finding : findings) errors.push_back(finding.text);
    if (!errors.empty()) throw ParameterFileError(listed(errors));
    return settings;
}

}  // namespace simulator
