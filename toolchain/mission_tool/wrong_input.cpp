// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/wrong_input.hpp"

#include <algorithm>
#include <utility>

#include "simulator/ground/text_file.hpp"

namespace mission_tool {

std::string placed(const std::string& name, int line, int column, const std::string& text) {
    return name + ':' + std::to_string(line) + ':' + std::to_string(column) + ": " + text;
}

std::string expected(const std::string& what, const std::string& found) {
    return "expected " + what + ", found " +
           (found.empty() ? "the end of the line" : "'" + simulator::printable(found) + "'");
}

void throwProblems(std::vector<LineProblem> problems) {
    if (problems.empty()) return;
    std::stable_sort(problems.begin(), problems.end(), [](const auto& a, const auto& b) {
        return std::make_pair(a.line, a.column) < std::make_pair(b.line, b.column);
    });
    std::vector<std::string> texts;
    for (const LineProblem& problem : problems) texts.push_back(problem.text);
    throw WrongInput(simulator::listed(texts));
}

}  // namespace mission_tool
