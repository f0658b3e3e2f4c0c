// SPDX-License-Identifier: GPL-3.0-or-later
// Between the files of this folder only: the records themselves.
#pragma once
#include "firmware/state/restart_record.hpp"

namespace firmware {
namespace safety {

extern state::SlowRecord steady;
extern state::FastRecord moving[2];
extern state::HangGyroRecord blind;
extern uint8_t number;                 // of the moving record written last, at moving[number & 1]
extern const state::FastRecord* last;  // to go on with; nullptr: nothing

}  // namespace safety
}  // namespace firmware
