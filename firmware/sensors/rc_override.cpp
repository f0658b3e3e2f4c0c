// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/sensors/rc_override.hpp"

#include <string.h>

#include "core/file_state.hpp"
#include "hal/clock.hpp"

namespace firmware {
namespace sensors {
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

}  // namespace

void setRcOverride(const uint16_t (&pulses_us)[hal::kRcChannels]) {
    for (uint8_t i = 0; i < hal::kRcChannels; ++i)
        if (pulses_us[i] != UINT16_MAX) override.override_us[i] = pulses_us[i];
    override.overridden = true;
    override.override_ms = hal::now_ms();
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
