// SPDX-License-Identifier: GPL-3.0-or-later
// The text of each parameter for people: firmware/state/parameters.csv. The firmware's own table
// knows name, range and default, too; a test holds the two against each other.
#pragma once
#include <string>
#include <vector>

namespace param_tool {

struct Explained {
    std::string name, unit;
    std::string lowest, highest, initial;  // as written
    std::string meaning;
};

std::vector<Explained> parseManual(const std::string& csv, const std::string& name);
const std::vector<Explained>& manual();                        // of this source tree
const Explained* explanationOf(const std::string& parameter);  // null: none

std::string document();  // docs/parameters.md

}  // namespace param_tool
