// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/sensors/radio.hpp"

#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "core/rom.hpp"
#include "firmware/sensors/rc_override.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/published.hpp"
#include "hal/rc_input.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<RadioState> : Writable<RadioState> {
    using Writable::state;
};
}  // namespace state

namespace sensors {

using namespace state;

namespace {

constexpr RadioState& published = Publisher<RadioState>::state();

// board encoder: a frame every 18.5 .. 26.5 ms; without one for a second the receiver is gone
constexpr uint32_t kFramesGone_us = 1000000;
constexpr uint8_t kBadReadings = 10;  // pulses below THR_FS_VALUE in a row that mean "lost"
constexpr uint8_t kGoodReadings = 3;
constexpr uint16_t kPulseLowest_us = 900;
constexpr uint16_t kPulseHighest_us = 2100;
constexpr int32_t kFullStick_cd = 4500;

struct Reception {
    // Of the last whole frame whose throttle was not below THR_FS_VALUE. Without a receiver the
    // encoder goes on with pulses of its own, which would move switches before the radio counts as
    // lost; 0: the channel was never received.
    uint16_t switch_us[hal::kRcChannels];
    uint16_t before_us[hal::kRcChannels];  // in the whole frame before
    uint8_t bad, good;                     // readings in a row
};
core::FileState<Reception> reception{};

// Where the stick is the surface it is so from the middle on: a dead zone is for what holds an
// attitude while the stick is let go.
int16_t deadZone_us(const Channel& channel) {
    return vehicle.mode == Mode::manual ? 0 : channel.dead_zone_us;
}

int16_t deflection_cd(const Channel& channel, uint16_t pulse_us) {
    const int16_t dead_zone_us = deadZone_us(channel);
    const int16_t from_trim = static_cast<int16_t>(pulse_us) - channel.trim_us;
    const bool above = from_trim > 0;
    const int16_t beyond = (above ? from_trim : -from_trim) - dead_zone_us;
    const int16_t span =
        (above ? channel.max_us - channel.trim_us : channel.trim_us - channel.min_us) -
        dead_zone_us;
    if (beyond <= 0 || span <= 0) return 0;
    const int32_t cd = beyond < span ? (kFullStick_cd * beyond + span / 2) / span : kFullStick_cd;
    return static_cast<int16_t>(above == (channel.reverse < 0) ? -cd : cd);
}

int8_t throttlePercent(const Channel& channel, uint16_t pulse_us) {
    const int16_t lowest_us = channel.min_us + channel.dead_zone_us;
    const int16_t span = channel.max_us - lowest_us;
    if (span <= 0) return 0;
    const int16_t above = core::limit<int16_t>(pulse_us - lowest_us, 0, span);
    const int8_t percent = static_cast<int8_t>(static_cast<int32_t>(above) * 100 / span);
    return channel.reverse < 0 ? 100 - percent : percent;
}

int16_t stick_cd(uint8_t number) {
    return deflection_cd(parameters.channel[number], published.pulse_us[number]);
}

uint16_t pulseInRange_us(uint16_t us) { return core::limit(us, kPulseLowest_us, kPulseHighest_us); }

// True: the ground station holds all that steers and may stand in for a receiver that is gone. Of
// one channel alone it may not: the other sticks would stay where they were.
bool groundFlies() {
    if (!rcOverridden()) return false;
    uint8_t held = 0;
    for (uint8_t i = 0; i < hal::kRcChannels; ++i) {
        uint16_t us;
        if (!rcOverride(i, us)) continue;
        published.pulse_us[i] = pulseInRange_us(us);
        held |= static_cast<uint8_t>(1 << i);
    }
    const uint8_t wanted =
        static_cast<uint8_t>(1 << (parameters.map_roll - 1) | 1 << (parameters.map_pitch - 1) |
                             1 << (parameters.map_throttle - 1));
    return (held & wanted) == wanted;
}

void countReadings(bool throttle_says_lost) {
    if (throttle_says_lost) {
        reception.good = 0;
        if (reception.bad < kBadReadings) ++reception.bad;
    } else {
        if (reception.good < kGoodReadings) ++reception.good;
        if (reception.good >= kGoodReadings) reception.bad = 0;
    }
}

bool same(uint16_t a_us, uint16_t b_us) {
    constexpr uint16_t kStill_us = 50;
    return (a_us > b_us ? a_us - b_us : b_us - a_us) <= kStill_us;
}

// What is switched lasts, so it is not read from a frame with an edge too many or too few, and not
// from a single one.
void readSwitches() {
    uint16_t whole_us[hal::kRcChannels] = {};
    const bool overridden = rcOverridden();
    if (!hal::rcReadWhole(whole_us) && !overridden) return;
    for (uint8_t i = 0; i < hal::kRcChannels; ++i) {
        if (overridden && rcOverride(i, whole_us[i])) {
            reception.switch_us[i] = pulseInRange_us(whole_us[i]);
        } else if (whole_us[i] != 0) {
            const uint16_t us = pulseInRange_us(whole_us[i]);
            // the first is taken as it is: after a restart in the air the mode waits for it
            uint16_t& before_us = reception.before_us[i];
            if (before_us == 0 || same(us, before_us)) reception.switch_us[i] = us;
            before_us = us;
        }
    }
}

// The encoder's own frames are whole, too: none of them may be left for later.
void ignoreSwitches() {
    uint16_t unused[hal::kRcChannels];
    (void)hal::rcReadWhole(unused);
}

void scale() {
    const int8_t rolls = parameters.rudder_only != 0 ? parameters.map_yaw : parameters.map_roll;
    published.roll_cd = stick_cd(rolls - 1);
    published.pitch_cd = stick_cd(parameters.map_pitch - 1);
    published.yaw_cd = stick_cd(parameters.map_yaw - 1);
    const uint8_t throttle = parameters.map_throttle - 1;
    published.throttle_pct =
        throttlePercent(parameters.channel[throttle], published.pulse_us[throttle]);
}

void centre() {
    published.roll_cd = published.pitch_cd = published.yaw_cd = 0;
    published.throttle_pct = 0;
}

constexpr uint16_t kSwitchUp_us = 1750;
// upper ends of the six bands, us
constexpr uint16_t kBands_us[] ROM = {1230, 1360, 1490, 1620, 1749, 2199};

}  // namespace

void runRadio() {
    uint16_t pulses[hal::kRcChannels];
    const bool fresh = hal::rcRead(pulses);
    if (fresh)
        for (uint8_t i = 0; i < hal::kRcChannels; ++i)
            if (pulses[i] != 0) published.pulse_us[i] = pulseInRange_us(pulses[i]);
    const bool ground_flies = groundFlies();
    const bool gone = !fresh && !ground_flies;
    if (gone && hal::rcAge_us() < kFramesGone_us) {
        // between two frames: whether the last was whole is known with the first edge of the next
        const bool obeyed = reception.bad == 0 && !published.lost && published.heard;
        return obeyed ? readSwitches() : ignoreSwitches();
    }

    const uint16_t throttle_us = published.pulse_us[parameters.map_throttle - 1];
    if (fresh || ground_flies)
        countReadings(parameters.throttle_failsafe != 0 &&
                      static_cast<int16_t>(throttle_us) < parameters.throttle_failsafe_us);
    published.lost = gone || reception.bad >= kBadReadings;
    if (published.lost) {
        centre();
        return;
    }
    if (reception.bad != 0) return;  // may be the encoder's own: what was received before it counts
    published.heard = true;
    if (ground_flies) readSwitches();
    scale();
}

uint8_t modeSwitchPosition() {
    if (published.lost || !published.heard) return 0;
    const uint16_t pulse_us = reception.switch_us[parameters.mode_channel - 1];
    if (pulse_us <= 900) return 0;
    for (uint8_t i = 0; i < core::count(kBands_us); ++i)
        if (pulse_us <= core::romRead(kBands_us[i])) return i + 1;
    return 0;
}

SwitchPosition switchPosition(uint8_t channel) {
    constexpr uint16_t kLow_us = 1200, kHigh_us = 1800;  // ArduPilot's
    const uint16_t pulse_us = reception.switch_us[channel - 1];
    if (published.lost || pulse_us == 0) return SwitchPosition::unknown;
    if (pulse_us <= kLow_us) return SwitchPosition::low;
    return pulse_us >= kHigh_us ? SwitchPosition::high : SwitchPosition::middle;
}

bool switchIsUp(int8_t channel) {
    return channel != 0 && !published.lost && reception.switch_us[channel - 1] > kSwitchUp_us;
}

}  // namespace sensors
}  // namespace firmware
