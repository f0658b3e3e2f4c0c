// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/sensors/rc_override.hpp"

#include <string.h>

#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "firmware/state/parameters.hpp"
#include "hal/clock.hpp"

namespace firmware {
namespace sensors {

using namespace state;

namespace {

struct Override {
    uint32_t override_ms;  // when the last one came
    uint16_t override_us[hal::kRcChannels];
    bool overridden;  // once, since they were last released
};
core::FileState<Override> override{};

// A ground station repeats its sticks at 10 Hz or so; one that falls silent must not hold the
// airplane in its last turn.
constexpr uint16_t kOverrideLasts_ms = 3000;

uint16_t between_us(int16_t from_us, int16_t to_us, int16_t thousandths) {
    const int32_t span_us = to_us - from_us;
    return static_cast<uint16_t>(from_us + span_us * thousandths / kFullStick);
}

// A reversed channel is turned round once more when it is read, so that the stick means what it
// shows.
uint16_t stick_us(const Channel& channel, int16_t deflection) {
    if (deflection == kNoStick) return 0;
    const int16_t limited = core::limit<int16_t>(deflection, -kFullStick, kFullStick);
    const int16_t turned = channel.reverse < 0 ? -limited : limited;
    if (turned < 0) return between_us(channel.trim_us, channel.min_us, -turned);
    return between_us(channel.trim_us, channel.max_us, turned);
}

uint16_t throttle_us(const Channel& channel, int16_t open) {
    if (open == kNoStick) return 0;
    const int16_t limited = core::limit<int16_t>(open, 0, kFullStick);
    if (channel.reverse < 0) return between_us(channel.max_us, channel.min_us, limited);
    return between_us(channel.min_us, channel.max_us, limited);
}

}  // namespace

void setRcOverride(const uint16_t (&pulses_us)[hal::kRcChannels]) {
    for (uint8_t i = 0; i < hal::kRcChannels; ++i)
        if (pulses_us[i] != UINT16_MAX) override.override_us[i] = pulses_us[i];
    override.overridden = true;
    override.override_ms = hal::now_ms();
}

void setStickOverride(const Deflections& to) {
    const Channel* channels = parameters.channel;
    const uint8_t roll = parameters.map_roll - 1, pitch = parameters.map_pitch - 1;
    const uint8_t throttle = parameters.map_throttle - 1, yaw = parameters.map_yaw - 1;
    uint16_t pulses_us[hal::kRcChannels];
    memset(pulses_us, 0xFF, sizeof pulses_us);
    pulses_us[roll] = stick_us(channels[roll], to.roll);
    pulses_us[pitch] = stick_us(channels[pitch], to.pitch);
    pulses_us[throttle] = throttle_us(channels[throttle], to.throttle);
    pulses_us[yaw] = stick_us(channels[yaw], to.yaw);
    setRcOverride(pulses_us);
}

bool rcOverride(uint8_t channel, uint16_t& pulse_us) {
    if (override.override_us[channel] == 0) return false;
    if (hal::now_ms() - override.override_ms > kOverrideLasts_ms) {
        rcOverrideRelease();
        return false;
    }
    pulse_us = override.override_us[channel];
    return true;
}

bool rcOverridden() { return override.overridden; }

void rcOverrideRelease() {
    memset(override.override_us, 0, sizeof override.override_us);
    override.overridden = false;
}

}  // namespace sensors
}  // namespace firmware
