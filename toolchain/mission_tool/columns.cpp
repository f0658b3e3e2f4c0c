// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/columns.hpp"

#include <algorithm>
#include <cmath>

namespace mission_tool {

std::string inColumns(const std::vector<Cells>& lines, const std::vector<bool>& right) {
    std::vector<size_t> widths(right.size(), 0);
    for (const Cells& line : lines)
        for (size_t c = 0; c < widths.size(); ++c) widths[c] = std::max(widths[c], line[c].size());
    std::string text;
    for (const Cells& line : lines) {
        std::string row;
        for (size_t c = 0; c < widths.size(); ++c) {
            const std::string space(widths[c] - line[c].size(), ' ');
            row += (c == 0 ? "" : "  ") + (right[c] ? space + line[c] : line[c] + space);
        }
        row.erase(row.find_last_not_of(' ') + 1);
        text += row + '\n';
    }
    return text;
}

std::string minutesAndSeconds(double time_s) {
    const long seconds = std::lround(std::min(1e7, std::max(0.0, time_s)));
    return format("%ld:%02ld", seconds / 60, seconds % 60);
}

}  // namespace mission_tool
