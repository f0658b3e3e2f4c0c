// SPDX-License-Identifier: GPL-3.0-or-later
// What the user gave and the tool cannot use, told as "name:line:column: expected ..., found ...".
#pragma once
#include <stdexcept>
#include <string>

namespace mission_tool {

class WrongInput : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

std::string placed(const std::string& name, int line, int column, const std::string& text);
std::string expected(const std::string& what, const std::string& found);  // found empty: the end

}  // namespace mission_tool
