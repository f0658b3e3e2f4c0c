// SPDX-License-Identifier: GPL-3.0-or-later
// The level 3 commands that only the APM 1.0 set has.
#include "core/file_state.hpp"
#include "firmware/actuators/relay.hpp"
#include "firmware/mission/engine.hpp"
#include "firmware/mission/handlers.hpp"
#include "firmware/mission/host.hpp"
#include "firmware/mission/mission.hpp"
#include "firmware/mission/servo_relay_events.hpp"
#include "firmware/mission/speed.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/parameter_slots.hpp"
#include "firmware/state/parameters.hpp"

namespace firmware {
namespace mission {

using namespace notify;
using namespace state;
using namespace actuators;

namespace {

constexpr uint8_t kGainKinds = 5;
constexpr uint8_t kGainIndices = 8;
constexpr uint8_t kFirstGainId = 0x60;
constexpr uint8_t n = kNoSlot;

// Which parameter plays the part: its slot. The loops of this firmware are not those of APM 1.0:
// one controller of speed and height has the part of four, and where a time stands for a gain, or
// limits for an integrator's own, there is no counterpart and the command is refused.
// clang-format off
constexpr uint8_t kGainSlots[kGainKinds][kGainIndices] ROM = {
    // servo roll           servo pitch            servo rudder          nav roll              pitch by airspeed
    // pitch by altitude    throttle by energy     throttle by altitude
    {slot::rll2srv_p,       slot::ptch2srv_p,      slot::yaw2srv_slip,   n,                    slot::tecs_spdweight,   // Kp
     n,                     n,                     n},
    {slot::rll2srv_i,       slot::ptch2srv_i,      slot::yaw2srv_int,    n,                    slot::tecs_integ_gain,  // Ki
     slot::tecs_integ_gain, slot::tecs_integ_gain, slot::tecs_integ_gain},
    {slot::rll2srv_d,       slot::ptch2srv_d,      slot::yaw2srv_damp,   slot::navl1_damping,  slot::tecs_ptch_damp,   // Kd
     slot::tecs_ptch_damp,  slot::tecs_thr_damp,   slot::tecs_thr_damp},
    {slot::rll2srv_imax,    slot::ptch2srv_imax,   slot::yaw2srv_imax,   n,                    n,  // integrator max
     n,                     n,                     n},
    // Kff: pitch comp, rudder mix, pitch to throttle
    {slot::ptch2srv_rll,    slot::kff_rddrmix,   n,                  n,                   n,
     n,                     n,                   n},
};
// clang-format on

struct Radio {
    bool radio_off;
};
core::FileState<Radio> radio{};

struct Variable {
    uint8_t waiting;  // for it: a bit a link, and the log's
    uint8_t slot;
};
core::FileState<Variable> variable{};
constexpr uint8_t kLog = 1u << kLinks, kEveryLink = kLog - 1;

void sendVariable(uint8_t slot, uint8_t to) {
    if (variable.waiting != 0 && variable.slot != slot)
        sendStatusText(Severity::warning, STATUS_TEXT("Mission: parameter # not sent"),
                       variable.slot);
    variable.slot = slot;
    variable.waiting = to;
    reportVariables();
}

}  // namespace

void setSlot(uint8_t slot, float value) {
    if (slot == kNoSlot || !parameterSet(slot, value))
        sendStatusText(Severity::warning, STATUS_TEXT("Mission: parameter # not set"), slot);
}

Jump jumpToFirst(const Record&) { return {1, ::mission::kForEver}; }

// The index stands in p2; the 1.0 firmware had it in p1.
Jump jumpToIndex(const Record& record) {
    const int32_t target = record.p2 != 0 ? record.p2 : record.p1;
    return {static_cast<uint8_t>(target), ::mission::kForEver};
}

void changeMode(const Record& record) {
    const Mode mode = static_cast<Mode>(record.p1);
    if (mode != Mode::automatic) leaveForMode(mode);
}

// To every link, as a broadcast: the ground station may be on any of them.
void queryVariable(const Record& record) { sendVariable(record.p1, kEveryLink); }
void broadcastVariable(const Record& record) { sendVariable(record.p1, kEveryLink | kLog); }

void reportVariables() {
    uint16_t row;
    if (variable.waiting == 0 || !parameterOfSlot(variable.slot, row)) return;
    for (uint8_t link = 0, bit = 1; link < kLinks; ++link, bit = static_cast<uint8_t>(bit << 1))
        if ((variable.waiting & bit) != 0 && host.sendParameter(link, row)) variable.waiting ^= bit;
    if ((variable.waiting & kLog) != 0 && host.logParameter(static_cast<uint8_t>(row)))
        variable.waiting ^= kLog;
}

void switchRadio(const Record& record) { radio.radio_off = record.p1 == 0; }
bool telemetryMuted() { return radio.radio_off; }
void radioHeard() { radio.radio_off = false; }

void cruiseSpeed(const Record& record) { setAirSpeed(record.p1 * 100); }
void cruiseThrottle(const Record& record) { setCruiseThrottle(static_cast<int8_t>(record.p1)); }

void resetHome(const Record& record) {
    Record marked = record;
    marked.p1 = record.p2 == 0 && record.p3 == 0 && record.p4 == 0;
    setHomeAction(marked);
}

uint8_t gainSlot(uint8_t id, uint8_t index) {
    const uint8_t kind = static_cast<uint8_t>(id - kFirstGainId);
    if (kind >= kGainKinds || index >= kGainIndices) return kNoSlot;
    return core::romRead(kGainSlots[kind][index]);
}

float gain(const Record& record) { return static_cast<float>(record.p2) / 100000.0f; }

void setGain(const Record& record) { setSlot(gainSlot(record.id, record.p1), gain(record)); }

uint8_t channelSlot(uint8_t id, uint8_t index) {
    if (index >= 8) return kNoSlot;
    const slot::ChannelPart part = id == 0x70 ? slot::trim : id == 0x71 ? slot::max : slot::min;
    return slot::ofChannel(static_cast<uint8_t>(index + 1), part);
}

void setChannel(const Record& record) {
    setSlot(channelSlot(record.id, record.p1), static_cast<float>(record.p2));
}

// The trims of elevons (0, 1) are those of their channels, where there are elevons.
uint8_t otherRadioSlot(uint8_t index) {
    if (index < 2 && parameters.elevon_output != 0)
        return slot::ofChannel(static_cast<uint8_t>(index + 1), slot::trim);
    return index == 2 ? static_cast<uint8_t>(slot::thr_fs_value) : kNoSlot;
}

void setOtherRadio(const Record& record) {
    setSlot(otherRadioSlot(record.p1), static_cast<float>(record.p2));
}

void repeatEvent(const Record& record) {
    constexpr uint8_t kRelayEvent = 6;
    constexpr uint8_t kFirstServo = 4;  // event 1 is CH_4_TOGGLE
    if (record.p1 == 0 || record.p1 == 10) return stopEvents();
    const bool relay = record.p1 == kRelayEvent;
    const uint8_t output = relay ? kRelayOutput : static_cast<uint8_t>(record.p1 - 1 + kFirstServo);
    repeatToggles(output, static_cast<uint16_t>(record.p2), static_cast<uint16_t>(record.p4),
                  static_cast<uint16_t>(record.p3));
}

void setRelayP1(const Record& record) { relaySet(record.p1 != 0); }

void setPulse(const Record& record) {
    constexpr uint16_t kShortest_us = 800;
    const uint16_t pulse_us = static_cast<uint16_t>(record.p2);
    holdOutput(static_cast<uint8_t>(record.p1 + 1),
               pulse_us != 0 && pulse_us < kShortest_us ? kShortest_us : pulse_us);
}

}  // namespace mission
}  // namespace firmware
