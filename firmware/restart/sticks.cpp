// SPDX-License-Identifier: GPL-3.0-or-later
// While the program hangs: the receiver's pulses to the servos as they come, one output a call. As
// in MANUAL, but for dead zones.
#include "core/maths.hpp"
#include "firmware/outputs.hpp"
#include "firmware/parameters.hpp"
#include "firmware/vehicle.hpp"
#include "hal/guard.hpp"
#include "hal/rc_input.hpp"

namespace firmware {
namespace {

uint8_t turn;

uint16_t pulseOf(int8_t channel) { return hal::rcPulse_us(static_cast<uint8_t>(channel - 1) & 7); }

}  // namespace
}  // namespace firmware

namespace hal {

void servosForgotten() {
    using namespace firmware;
    turn = (turn + 1) & 3;
    const int8_t channels[] = {parameters.map_roll, parameters.map_pitch, parameters.map_throttle,
                               parameters.map_yaw};
    const uint16_t pulse_us = pulseOf(channels[turn]);
    const bool motor = turn == 2;
    if (pulse_us == 0 || (motor && !vehicle.armed)) return;
    hal::servoWrite(turn, pulse_us * 2);
}

}  // namespace hal
