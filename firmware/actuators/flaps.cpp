// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/actuators/flaps.hpp"

#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "firmware/guidance/guidance.hpp"
#include "firmware/state/mode_traits.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace actuators {

using namespace state;
using namespace guidance;

core::FileState<Flaps> flaps{};

namespace {

constexpr int16_t kFull = core::Ratio::kOne;
constexpr int16_t kPercent = core::Ratio(0.01f).raw;
constexpr float kMargin_mps = 0.5f;  // over the speed at which a stage goes out, it goes in

struct Extension {
    uint8_t stage;  // that is out: 1, 2, or 0
};
core::FileState<Extension> extension{};

// In when the radio has never been heard; when it is lost the lever stays where it was.
int16_t lever() {
    if (parameters.flap_channel == 0) return 0;
    const uint8_t index = static_cast<uint8_t>(parameters.flap_channel - 1);
    const Channel& channel = parameters.channel[index];
    const int16_t span_us = channel.max_us - channel.min_us;
    const int16_t open_us = static_cast<int16_t>(vehicle.radio.pulse_us[index]) - channel.min_us;
    if (open_us <= 0 || span_us <= 0) return 0;
    return open_us >= span_us ? kFull : static_cast<int16_t>(int32_t{open_us} * kFull / span_us);
}

bool slowEnough(uint8_t which) {
    const int8_t speed_mps = parameters.flap[which - 1].speed_mps;
    const float margin_mps = which == extension.stage ? kMargin_mps : 0;
    return speed_mps != 0 && demandedAirspeed_mps() <= speed_mps + margin_mps;
}

// The demanded airspeed does not come back from what the flaps do.
int16_t byItself() {
    const bool guides = guidesItself();
    extension.stage = guides ? (slowEnough(2) ? 2 : slowEnough(1)) : 0;
    int8_t percent = extension.stage == 0 ? 0 : parameters.flap[extension.stage - 1].percent;
    const bool lands = guides && vehicle.demand.path == Path::land;
    if (lands && parameters.land_flap_pct != 0) percent = parameters.land_flap_pct;
    return percent * kPercent;
}

void move(core::Ratio& flap, int16_t to) {
    const int16_t step = parameters.flap_slew_pct * kPercent / 10;
    const int16_t left = to - flap.raw;
    flap.raw += step == 0 ? left : core::limit<int16_t>(left, -step, step);
}

}  // namespace

void runFlaps() {
    const int16_t by_lever = lever(), by_itself = byItself();
    move(flaps.lever, by_lever);
    move(flaps.out, by_lever > by_itself ? by_lever : by_itself);
}

}  // namespace actuators
}  // namespace firmware
