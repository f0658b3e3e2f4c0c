// SPDX-License-Identifier: GPL-3.0-or-later
// Words in columns, two blanks apart.
#pragma once
#include <cstdio>
#include <string>
#include <vector>

namespace mission_tool {

using Cells = std::vector<std::string>;

// right: which columns end at the same place; every line has as many cells.
std::string inColumns(const std::vector<Cells>& lines, const std::vector<bool>& right);

template <class... Values>
std::string format(const char* how, Values... values) {
    char text[200];
    std::snprintf(text, sizeof text, how, values...);
    return text;
}

std::string minutesAndSeconds(double time_s);  // "12:05"

}  // namespace mission_tool
