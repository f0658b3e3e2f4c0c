// SPDX-License-Identifier: GPL-3.0-or-later
// Between the files of this folder only: the records themselves.
#pragma once
#include "firmware/restart/record.hpp"

namespace firmware {

extern SteadyRecord steady;
extern MovingRecord moving[2];
extern BlindRecord blind;
extern uint8_t number;            // of the moving record written last, at moving[number & 1]
extern const MovingRecord* last;  // to go on with; nullptr: nothing

}  // namespace firmware
