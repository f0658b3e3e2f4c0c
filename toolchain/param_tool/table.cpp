// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/param_tool/table.hpp"

#include <algorithm>
#include <array>

#include "toolchain/param_tool/manual.hpp"

namespace param_tool {
namespace {

using Line = std::array<std::string, 6>;

Line lineOf(const Parameter& p) {
    const Explained* const explained = explanationOf(p.name);
    return {(p.value == p.initial ? "  " : "* ") + p.name,
            spelled(p.value),
            explained != nullptr ? explained->unit : "",
            spelled(p.initial),
            spelled(p.lowest) + " to " + spelled(p.highest),
            explained != nullptr ? explained->meaning : ""};
}

}  // namespace

std::string settingsOf(const std::vector<Parameter>& parameters, bool changed) {
    std::string text;
    for (const Parameter& p : parameters)
        if (p.stored && (!changed || p.value != p.initial))
            text += p.name + ',' + spelled(p.value) + '\n';
    return text;
}

std::string tableOf(const std::vector<Parameter>& parameters, bool changed) {
    std::vector<Line> lines = {{"  name", "value", "unit", "default", "range", "meaning"}};
    for (const Parameter& p : parameters)
        if (p.stored && (!changed || p.value != p.initial)) lines.push_back(lineOf(p));
    std::array<size_t, 6> widths{};
    for (const Line& line : lines)
        for (size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
    std::string text;
    for (const Line& line : lines) {
        std::string row;
        for (size_t i = 0; i < line.size(); ++i)
            row += line[i] + std::string(widths[i] + 2 - line[i].size(), ' ');
        row.erase(row.find_last_not_of(' ') + 1);
        text += row + '\n';
    }
    return text;
}

}  // namespace param_tool
