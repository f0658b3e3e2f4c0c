// SPDX-License-Identifier: GPL-3.0-or-later
// What the user gave and the tool cannot use, shown as "name:line:column: expected ..., found ...".
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace mission_tool {

// A place of its own for each line of a file that has several.
struct LineProblem {
    int line, column;
    std::string text;  // with its place
};

class WrongInput : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

std::string placed(const std::string& name, int line, int column, const std::string& text);
// All of them in the order of the file; throws WrongInput with the first 50 when there are any.
void throwProblems(std::vector<LineProblem> problems);

std::string expected(const std::string& what, const std::string& found);  // found empty: the end

}  // namespace mission_tool
