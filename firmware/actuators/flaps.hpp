// SPDX-License-Identifier: GPL-3.0-or-later
// How far out the flaps are wanted: by the pilot's lever (FLAP_IN_CHANNEL), and in modes that fly
// by themselves by the airspeed that is demanded (FLAP_1_, FLAP_2_), moved no faster than
// FLAP_SLEWRATE.
#pragma once
#include "core/file_state.hpp"
#include "core/fixed.hpp"

namespace firmware {
namespace actuators {

struct Flaps {  // 0 in, 1 all out
    core::Ratio lever;
    core::Ratio out;  // what of both is more
};
extern core::FileState<Flaps> flaps;

void runFlaps();  // 10 Hz

}  // namespace actuators
}  // namespace firmware
