// SPDX-License-Identifier: GPL-3.0-or-later
// While the program hangs: the sticks to the servos as in MANUAL, one output a call. And what the
// gyros measure is kept for the attitude after the restart.
#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "firmware/actuators/outputs.hpp"
#include "firmware/safety/restart_records.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"
#include "hal/hang_timer.hpp"
#include "hal/rc_input.hpp"

namespace firmware {
namespace safety {

using namespace state;

namespace {

constexpr uint8_t kAileron = 0, kElevator = 1, kThrottle = 2, kRudder = 3;

struct Turn {
    uint8_t output;  // whose turn it is
};
core::FileState<Turn> turn{};

// Numbered from 1, as RCMAP_ has them.
uint16_t pulse_us(int8_t channel) { return hal::rcPulse_us(static_cast<uint8_t>(channel - 1) & 7); }
int16_t fromTrim_us(int8_t channel) {
    return static_cast<int16_t>(pulse_us(channel)) - parameters.channel[channel - 1].trim_us;
}

// The elevator's servo and its partner's, turned as the kind of the pair says (control/mixing.hpp);
// half of either stick.
uint16_t paired_us(int8_t kind, int8_t other_stick) {
    const Channel& servo = parameters.channel[turn.output];
    const int16_t both_us = fromTrim_us(parameters.map_pitch), apart_us = fromTrim_us(other_stick);
    const bool left = turn.output == kElevator;
    const int16_t sum_us = (left ? both_us - apart_us : both_us + apart_us) / 2;
    const bool turned = left ? kind > 2 : (kind & 1) == 0;
    const int16_t wanted_us = servo.trim_us + (turned ? -sum_us : sum_us);
    return static_cast<uint16_t>(core::limit(wanted_us, servo.min_us, servo.max_us));
}

uint16_t wanted_us() {
    if (parameters.elevon_output != 0 && turn.output <= kElevator)
        return paired_us(parameters.elevon_output, parameters.map_roll);
    if (parameters.elevon_output == 0 && parameters.vtail_output != 0 && (turn.output & 1) != 0)
        return paired_us(parameters.vtail_output, parameters.map_yaw);
    if (turn.output == kAileron) return pulse_us(parameters.map_roll);
    if (turn.output == kElevator) return pulse_us(parameters.map_pitch);
    return pulse_us(turn.output == kThrottle ? parameters.map_throttle : parameters.map_yaw);
}

}  // namespace
}  // namespace safety
}  // namespace firmware

namespace hal {

void passSticksToServos() {
    using namespace firmware::safety;
    using namespace firmware::sensors;
    using namespace firmware::state;
    if (turn.output == kRudder) {
        saveHangTurn(records.hang.turn);
        updateChecksum(records.hang, newestFastRecord());
    }
    turn.output = (turn.output + 1) & 3;
    const bool silent = vehicle.radio.lost || pulse_us(parameters.map_pitch) == 0 || wrongBoard();
    if (silent || (!vehicle.armed && turn.output == kThrottle)) return;
    const uint16_t now_us = wanted_us();
    firmware::actuators::outputPassStick(turn.output, now_us);
}

}  // namespace hal
