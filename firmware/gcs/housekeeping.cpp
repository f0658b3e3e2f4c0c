// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/housekeeping.hpp"

#include <stddef.h>
#include <string.h>

#include "core/maths.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/gcs/telemetry.hpp"
#include "firmware/notify/status_text.hpp"
#include "hal/clock.hpp"
#include "hal/rc_input.hpp"

namespace firmware {
namespace gcs {

using namespace notify;
using namespace state;

namespace {

uint32_t heard_ms;
uint32_t override_ms;  // when the last RC_CHANNELS_OVERRIDE came
uint16_t override_us[hal::kRcChannels];
bool overridden;  // once, since they were last released

// A ground station repeats its sticks at 10 Hz or so; one that falls silent must not hold the
// airplane in its last turn.
constexpr uint16_t kOverrideLasts_ms = 3000;

bool fromGround(const mavlink::Frame& frame) {
    return frame.system == static_cast<uint8_t>(parameters.ground_system_id);
}

}  // namespace

void housekeepingStart() {
    heard_ms = 0;
    rcOverrideRelease();
}

uint32_t groundHeard_ms() { return heard_ms; }

bool onHeartbeat(Link&, const mavlink::Frame& frame) {
    if (fromGround(frame)) heard_ms = hal::now_ms();
    return true;
}

bool onPing(Link& link, const mavlink::Frame& frame) {
    mavlink::Ping message = frame.read<mavlink::Ping>();
    if (message.target_system != 0) return true;  // somebody's answer
    message.target_system = frame.system;
    message.target_component = frame.component;
    return send(link, message);
}

bool onTimesync(Link& link, const mavlink::Frame& frame) {
    mavlink::Timesync message = frame.read<mavlink::Timesync>();
    if (message.tc1 != 0) return true;  // somebody's answer
    message.tc1 = int64_t{1000000} * hal::now_ms();
    message.target_system = frame.system;
    message.target_component = frame.component;
    return send(link, message);
}

bool onRequestDataStream(Link& link, const mavlink::Frame& frame) {
    const auto asked = frame.read<mavlink::RequestDataStream>();
    setStreamRate(link, asked.req_stream_id, asked.start_stop == 0 ? 0 : asked.req_message_rate);
    return true;
}

// SiK radios report how full their own buffer is, so that nothing need be lost in it.
bool onRadioStatus(Link& link, const mavlink::Frame& frame) {
    const auto radio = frame.read<mavlink::RadioStatus>();
    int8_t change = 0;
    if (radio.txbuf < 20) {
        change = 15;
    } else if (radio.txbuf < 50) {
        change = 5;
    } else if (radio.txbuf > 95) {
        change = -10;
    } else if (radio.txbuf > 90) {
        change = -5;
    }
    const int8_t slowdown = static_cast<int8_t>(link.slowdown_pct + change);
    link.slowdown_pct = static_cast<uint8_t>(core::limit<int8_t>(slowdown, 0, 90));
    return true;
}

// 0 gives a channel back to the receiver, 65535 leaves it as it is.
bool onRcChannelsOverride(Link&, const mavlink::Frame& frame) {
    if (!fromGround(frame)) return true;
    const auto message = frame.read<mavlink::RcChannelsOverride>();
    uint16_t wanted_us[hal::kRcChannels];
    memcpy(wanted_us, &message, sizeof wanted_us);  // they stand first
    static_assert(offsetof(mavlink::RcChannelsOverride, target_system) == sizeof wanted_us, "");
    for (uint8_t i = 0; i < hal::kRcChannels; ++i)
        if (wanted_us[i] != UINT16_MAX) override_us[i] = wanted_us[i];
    overridden = true;
    heard_ms = override_ms = hal::now_ms();
    return true;
}

bool rcOverride(uint8_t channel, uint16_t& pulse_us) {
    if (override_us[channel] == 0) return false;
    if (hal::now_ms() - override_ms > kOverrideLasts_ms) {
        rcOverrideRelease();
        return false;
    }
    pulse_us = override_us[channel];
    return true;
}

bool rcOverridden() { return overridden; }

void rcOverrideRelease() {
    memset(override_us, 0, sizeof override_us);
    overridden = false;
}

}  // namespace gcs
}  // namespace firmware
