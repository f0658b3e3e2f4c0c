// SPDX-License-Identifier: GPL-3.0-or-later
// The ground station's sticks in the place of the receiver's (RC_CHANNELS_OVERRIDE,
// MANUAL_CONTROL).
#pragma once
#include <stdint.h>

#include "hal/rc_input.hpp"

namespace firmware {
namespace sensors {

// 0 gives a channel back to the receiver, 65535 leaves it as it is. To be repeated: after 3 s of
// silence all are given back.
void setRcOverride(const uint16_t (&pulses_us)[hal::kRcChannels]);

// Deflections in thousandths: -1000 left, nose down .. 1000 right, nose up; throttle 0 .. 1000.
// What is beyond counts as the end.
struct Deflections {
    int16_t roll, pitch, throttle, yaw;
};
constexpr int16_t kFullStick = 1000;
constexpr int16_t kNoStick = INT16_MAX;  // this channel is given back to the receiver
// As setRcOverride with the pulses that RCn_MIN, _TRIM, _MAX and _REV make of it; the other
// channels stay as they are.
void setStickOverride(const Deflections& to);

// The pulse that takes the place of the receiver's; channel 0..7. False: not overridden.
bool rcOverride(uint8_t channel, uint16_t& pulse_us);
bool rcOverridden();       // false: none of the channels is
void rcOverrideRelease();  // all channels back to the receiver

}  // namespace sensors
}  // namespace firmware
