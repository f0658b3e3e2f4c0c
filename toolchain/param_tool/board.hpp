// SPDX-License-Identifier: GPL-3.0-or-later
// The board behind the tool: the firmware's own table and store on the tests' EEPROM.
#pragma once
#include <string>
#include <vector>

#include "toolchain/mission_tool/image.hpp"
#include "toolchain/param_tool/settings.hpp"

namespace param_tool {

struct Parameter {
    std::string name;
    float value, initial, lowest, highest;
    bool whole;
    bool stored;  // false: the length of a list of points, which no file of parameters makes
};

// Boots the board with this EEPROM; throws WrongInput when it is not this firmware's.
void powerUp(const mission_tool::Image& image, const std::string& name);

std::vector<Parameter> parameters();  // as they now stand, in the firmware's order

struct Rules {
    bool skip_unknown = false;
};
// Sets each; what the firmware refuses is reported. Nothing is left half done: look for errors first.
void set(const std::vector<Setting>& settings, const std::string& file, const Rules& rules,
         std::vector<Finding>& findings);

mission_tool::Image image();  // the EEPROM as it now is

}  // namespace param_tool
