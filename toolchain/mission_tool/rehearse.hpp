// SPDX-License-Identifier: GPL-3.0-or-later
// A mission flown before its flight: by the program behind toolchain/fly --native, once in calm air
// and once in wind.
#pragma once
#include <ostream>
#include <string>
#include <vector>

#include "toolchain/mission_tool/estimate.hpp"

namespace mission_tool {

struct Rehearsal {
    std::string name;     // of the mission, for whoever reads how it went
    std::string mission;  // a file that the simulator reads
    std::string airplane;
    std::string folder;  // receives calm/ and wind/
    std::string board;   // its EEPROM, 4096 bytes; empty: blank
    bool has_parameters = false;   // the board; else the airplane's .param is set
    std::vector<int> stored_navs;  // the mission is on the board: what is to be reached of it
    Wind wind = {6, 270.0};
    double expected_s = 0;  // of the flight in calm air; it is given up some time after that
    uint64_t seed = 1;
};

// Prints how both went and where their reports are. False: one was not completed. Throws WrongInput
// when the simulator does not fly it at all.
bool rehearseFlights(const Rehearsal& rehearsal, std::ostream& out);

}  // namespace mission_tool
