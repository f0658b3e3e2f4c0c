// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/wrong_input.hpp"

namespace mission_tool {
namespace {

// Garbage is quoted in part and never lets its control characters out.
std::string printable(const std::string& text) {
    constexpr size_t kMost = 40;
    std::string clean;
    for (unsigned char c : text.substr(0, kMost)) clean += c >= 32 && c < 127 ? char(c) : '?';
    return text.size() > kMost ? clean + "..." : clean;
}

}  // namespace

std::string placed(const std::string& name, int line, int column, const std::string& text) {
    return name + ':' + std::to_string(line) + ':' + std::to_string(column) + ": " + text;
}

std::string expected(const std::string& what, const std::string& found) {
    return "expected " + what + ", found " +
           (found.empty() ? "the end of the line" : "'" + printable(found) + "'");
}

}  // namespace mission_tool
