// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/housekeeping.hpp"

#include <stddef.h>
#include <string.h>

#include "core/maths.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/gcs/telemetry.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/sensors/rc_override.hpp"
#include "firmware/state/published.hpp"
#include "hal/clock.hpp"
#include "hal/rc_input.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<GroundState> : Writable<GroundState> {
    using Writable::state;
};
}  // namespace state

namespace gcs {

using namespace state;
using namespace sensors;

namespace {

constexpr GroundState& published = Publisher<GroundState>::state();

bool fromGround(const mavlink::Frame& frame) {
    return frame.system == static_cast<uint8_t>(parameters.ground_system_id);
}

}  // namespace

void housekeepingStart() {
    published.ground_heard_ms = 0;
    rcOverrideRelease();
}

bool onHeartbeat(Link&, const mavlink::Frame& frame) {
    if (fromGround(frame)) published.ground_heard_ms = hal::now_ms();
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

bool onRcChannelsOverride(Link&, const mavlink::Frame& frame) {
    if (!fromGround(frame)) return true;
    const auto message = frame.read<mavlink::RcChannelsOverride>();
    uint16_t wanted_us[hal::kRcChannels];
    memcpy(wanted_us, &message, sizeof wanted_us);  // they stand first
    static_assert(offsetof(mavlink::RcChannelsOverride, target_system) == sizeof wanted_us, "");
    setRcOverride(wanted_us);
    published.ground_heard_ms = hal::now_ms();
    return true;
}

// A joystick of the ground station. Its buttons mean what each ground station wants and are not
// looked at. Forward is nose down.
bool onManualControl(Link&, const mavlink::Frame& frame) {
    if (!fromGround(frame)) return true;
    const auto message = frame.read<mavlink::ManualControl>();
    const int16_t forward = core::limit<int16_t>(message.x, -kFullStick, kFullStick);
    const int16_t pitch = message.x == kNoStick ? kNoStick : -forward;
    setStickOverride({message.y, pitch, message.z, message.r});
    published.ground_heard_ms = hal::now_ms();
    return true;
}

}  // namespace gcs
}  // namespace firmware
