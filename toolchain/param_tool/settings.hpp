// SPDX-License-Identifier: GPL-3.0-or-later
// Values for parameters as a .param file gives them: a name and a number a line, parted by a comma
// or by spaces, '#' beginning a comment.
#pragma once
#include <string>
#include <vector>

namespace param_tool {

struct Setting {
    std::string name;
    double value;
    int line, name_column, value_column;
};

struct Finding {
    int line;
    bool error;  // else a warning
    std::string text;
};

// What cannot be read is reported in `findings`, line by line.
std::vector<Setting> parseSettings(const std::string& contents, const std::string& file,
                                   std::vector<Finding>& findings);

// A number as short as it can be, read back as the same float.
std::string spelled(float value);

}  // namespace param_tool
