// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/parameter_file.hpp"

#include <fstream>
#include <sstream>

#include "toolchain/param_tool/settings.hpp"

namespace simulator {

ParameterSettings readParameterFile(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    if (!file) throw ParameterFileError(path + ": cannot be read");
    std::vector<param_tool::Finding> findings;
    ParameterSettings settings;
    for (const auto& setting : param_tool::parseSettings(text.str(), path, findings))
        settings.push_back({setting.name, setting.value});
    if (!findings.empty()) throw ParameterFileError(findings.front().text);
    return settings;
}

}  // namespace simulator
