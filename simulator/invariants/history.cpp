// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/invariants/history.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "simulator/ground/link.hpp"

namespace simulator::invariants {

using namespace mavlink;

namespace {

constexpr double kStickMiddle_us = 1500, kStickEnd_us = 350;
constexpr double kThrottleOpen_us = 1150;
constexpr int kSwitchMoves_us = 50;
constexpr float kForceDisarm = 21196, kForceArm = 2989;  // MAV_CMD_COMPONENT_ARM_DISARM, param2
constexpr size_t kTexts = 100;

// What each command may bring about.
struct CommandRow {
    uint16_t number;
    Cause cause;
};
constexpr CommandRow kCommands[] = {
    {MavCmd::component_arm_disarm, Cause::arms},
    {MavCmd::do_set_mode, Cause::flight_mode},
    {MavCmd::nav_return_to_launch, Cause::flight_mode},
    {MavCmd::nav_loiter_unlim, Cause::flight_mode},
    {MavCmd::nav_waypoint, Cause::flight_mode},
    {MavCmd::nav_takeoff, Cause::flight_mode},
    {MavCmd::nav_land, Cause::flight_mode},
    {MavCmd::mission_start, Cause::flight_mode},
    {MavCmd::do_reposition, Cause::flight_mode},
    {MavCmd::do_change_altitude, Cause::flight_mode},
    {MavCmd::do_autotune_enable, Cause::flight_mode},
    {MavCmd::guided_change_altitude, Cause::flight_mode},
    {MavCmd::guided_change_speed, Cause::flight_mode},
    {MavCmd::do_land_start, Cause::flight_mode},
    {MavCmd::do_go_around, Cause::flight_mode},
    {MavCmd::do_fence_enable, Cause::flight_mode},
    {MavCmd::do_land_start, Cause::mission},
    {MavCmd::do_go_around, Cause::mission},
    {MavCmd::do_go_around, Cause::go_around},
    {MavCmd::do_land_start, Cause::go_around},  // on a final it is one
    {MavCmd::nav_land, Cause::go_around},       // the same
    {MavCmd::do_set_mission_current, Cause::mission},
    {MavCmd::do_jump, Cause::mission},
    {MavCmd::mission_start, Cause::mission},
    {MavCmd::do_set_servo, Cause::servo},
    {MavCmd::do_repeat_servo, Cause::servo},
    {MavCmd::do_set_parameter, Cause::parameter},
    {MavCmd::preflight_storage, Cause::parameter},
    {MavCmd::preflight_reboot_shutdown, Cause::reboot},
};

// Messages that do something whatever is in them.
struct MessageRow {
    uint16_t id;
    Cause cause;
};
constexpr MessageRow kMessages[] = {
    {Wire<SetMode>::id, Cause::flight_mode},
    {Wire<MissionItem>::id, Cause::flight_mode},  // "current" 2: GUIDED's target
    {Wire<MissionItemInt>::id, Cause::flight_mode},
    {Wire<SetPositionTargetGlobalInt>::id, Cause::flight_mode},
    {Wire<SetPositionTargetLocalNed>::id, Cause::flight_mode},
    {Wire<MissionSetCurrent>::id, Cause::mission},
    {Wire<MissionCount>::id, Cause::mission},
    {Wire<MissionClearAll>::id, Cause::mission},
    {Wire<MissionWritePartialList>::id, Cause::mission},
    {Wire<MissionItem>::id, Cause::mission},
    {Wire<MissionItemInt>::id, Cause::mission},
    {Wire<RcChannelsOverride>::id, Cause::overrides},
    {Wire<ManualControl>::id, Cause::overrides},
    {Wire<ParamSet>::id, Cause::parameter},
};

bool atEnd(uint16_t stick_us) { return std::abs(stick_us - kStickMiddle_us) > kStickEnd_us; }

// The index of the channel that a parameter names.
size_t channelAt(double number, size_t otherwise) {
    const double whole = std::round(number);
    return whole >= 1 && whole <= 8 ? static_cast<size_t>(whole) - 1 : otherwise;
}

std::string nameIn(const char (&id)[16]) { return {id, strnlen(id, sizeof id)}; }

}  // namespace

// A stick may have been made that switch; whether it was taken may be heard on another link. One
// that has no channel is looked for at the mode switch's.
size_t History::channelOf(const char* parameter) const {
    constexpr size_t kDefault = 7;
    const auto asked = asked_.find(parameter);
    if (asked == asked_.end()) return kDefault;
    return channelAt(asked->second.value, kDefault);
}

// Of a receiver whose travel is doubled, the low throttle stick is below what stands for its loss.
bool History::throttleSaysLost(const Snapshot& now) const {
    constexpr size_t kDefault = 2;
    const size_t at = channelAt(parameter("RCMAP_THROTTLE", 1 + kDefault), kDefault);
    const double doubled_us = kStickMiddle_us + 2 * (now.stick_us[at] - kStickMiddle_us);
    return now.wide && doubled_us < parameter("THR_FS_VALUE", 950);
}

void History::frame(const Snapshot& now) {
    const double now_s = now.time_s();
    bool fault = false;
    const auto moves = [&](size_t channel) {
        return std::abs(now.stick_us[channel] - before_.stick_us[channel]) > kSwitchMoves_us;
    };
    bool moved = moves(channelOf("FLTMODE_CH")) || moves(channelOf("RST_SWITCH_CH"));
    for (size_t i = 4; i < now.stick_us.size(); ++i) moved = moved || moves(i);
    if (moved || now.wide != before_.wide) mark(Cause::mode_switch, now_s);
    constexpr auto kRadio = static_cast<size_t>(Faulty::radio);
    const bool on = now.transmitting, was_on = before_.transmitting;
    const bool faulty = now.faulty[kRadio], was_faulty = before_.faulty[kRadio];
    // with a fault it may still be heard, as when its pulses have an edge too many
    const bool heard = on && (!was_on || (was_faulty && !faulty));
    if (heard || (throttleSaysLost(before_) && !throttleSaysLost(now)))
        mark(Cause::radio_back, now_s);
    if (on && now.nine_channels != nine_heard_) {
        mark(Cause::channel_count, now_s);
        nine_heard_ = now.nine_channels;
    }
    // what the encoder makes of no receiver: a low throttle on channel 3, where nobody looks for it
    const bool obeyed =
        parameter("THR_FAILSAFE", 1) < 0.5 || std::lround(parameter("RCMAP_THROTTLE", 3)) != 3;
    if (obeyed && (on != was_on || faulty != was_faulty)) mark(Cause::mode_switch, now_s);
    if (now.restarts != before_.restarts) mark(Cause::restart, now_s);
    if (now.transmitting) {
        if (atEnd(now.stick_us[0]) || atEnd(now.stick_us[1]) || atEnd(now.stick_us[3]))
            mark(Cause::stick, now_s);
        if (atEnd(now.stick_us[3])) mark(Cause::rudder, now_s);
        if (now.stick_us[2] > kThrottleOpen_us) mark(Cause::throttle, now_s);
    }
    for (size_t i = 0; i < now.faulty.size(); ++i) {
        if (now.faulty[i]) faulted_s_[i] = now_s;
        fault = fault || now.faulty[i];
    }
    if (fault) mark(Cause::fault, now_s);
    // the sticks are the pilot's again when no more come for 3 s, which moves them as well
    constexpr double kOverrideLasts_s = 3.1;
    if (now_s - override_s_ < kOverrideLasts_s) mark(Cause::overrides, now_s);
    before_ = now;
}

void History::mark(Cause cause, double now_s) {
    constexpr double kSame_s = 0.05;
    constexpr size_t kSpans = 20;
    std::vector<Span>& spans = causes_[static_cast<size_t>(cause)];
    if (!spans.empty() && now_s - spans.back().to_s < kSame_s)
        spans.back().to_s = now_s;
    else
        spans.push_back({now_s, now_s});
    if (spans.size() > kSpans) spans.erase(spans.begin());
}

double History::last_s(Cause cause) const {
    const auto& spans = causes_[static_cast<size_t>(cause)];
    return spans.empty() ? kNever_s : spans.back().to_s;
}

bool History::within(Cause cause, double from_s, double to_s) const {
    const auto& spans = causes_[static_cast<size_t>(cause)];
    return std::any_of(spans.begin(), spans.end(), [&](const Span& span) {
        return span.to_s >= from_s && span.from_s <= to_s;
    });
}

bool History::saidWithin(const char* begins, double from_s, double to_s) const {
    return std::any_of(said_.begin(), said_.end(), [&](const Said& each) {
        return each.time_s >= from_s && each.time_s <= to_s && each.text.rfind(begins, 0) == 0;
    });
}

bool History::reachedWithin(int item, double from_s, double to_s) const {
    const auto found = reached_s_.find(item);
    return found != reached_s_.end() && found->second >= from_s && found->second <= to_s;
}

double History::parameter(const std::string& name, double otherwise) const {
    const auto found = values_.find(name);
    return found == values_.end() ? otherwise : double(found->second);
}

void History::heartbeat(const Heartbeat& message, double now_s) {
    if (message.autopilot == MavAutopilot::invalid) return;
    heard_before_ = heard_;
    heard_ = {now_s, (message.base_mode & MavModeFlag::safety_armed) != 0, message.custom_mode};
    ++heartbeats_;
}

void History::text(const Statustext& message, double now_s) {
    if (said_.size() >= kTexts) said_.erase(said_.begin(), said_.begin() + kTexts / 2);
    said_.push_back({now_s, {message.text, strnlen(message.text, sizeof message.text)}});
}

void History::current(int item) {
    if (item == item_) return;
    item_before_ = item_;
    item_ = item;
    ++item_changes_;
}

void History::received(const Frame& frame, double now_s) {
    if (const auto m = as<Heartbeat>(frame)) heartbeat(*m, now_s);
    if (const auto m = as<Statustext>(frame)) text(*m, now_s);
    if (const auto m = as<MissionCurrent>(frame)) current(m->seq);
    if (const auto m = as<MissionItemReached>(frame)) reached_s_[m->seq] = now_s;
    if (const auto m = as<GlobalPositionInt>(frame)) position_ = m, position_s_ = now_s;
    if (const auto m = as<VfrHud>(frame)) hud_ = m, hud_s_ = now_s;
    if (const auto m = as<ParamValue>(frame)) {
        constexpr double kAnswer_s = 5;
        constexpr float kRounding = 0.5f;  // a refusal is answered by the value as it was
        const std::string name = nameIn(m->param_id);
        values_[name] = m->param_value;
        const auto asked = asked_.find(name);
        const bool taken = asked != asked_.end() && now_s - asked->second.time_s < kAnswer_s &&
                           std::abs(asked->second.value - m->param_value) <= kRounding;
        if (taken) set_[name] = m->param_value;
    }
    plan_.received(frame);
}

void History::command(uint16_t number, float param1, float param2, double now_s) {
    for (const CommandRow& row : kCommands)
        if (row.number == number) mark(row.cause, now_s);
    const bool magic = std::abs(param2 - kForceDisarm) < 1 || std::abs(param2 - kForceArm) < 1;
    if (number == MavCmd::component_arm_disarm && param1 < 0.5f && magic)
        mark(Cause::forces, now_s);
    constexpr double kTerminates = 42;
    if (number == MavCmd::do_flighttermination && param1 == 1 &&
        parameter("AFS_TERM_ACTION", 0) == kTerminates)
        mark(Cause::forces, now_s);
}

void History::sent(const Frame& frame, double now_s) {
    for (const MessageRow& row : kMessages)
        if (row.id == frame.id) mark(row.cause, now_s);
    if (const auto m = as<CommandLong>(frame)) command(m->command, m->param1, m->param2, now_s);
    if (const auto m = as<CommandInt>(frame)) command(m->command, m->param1, m->param2, now_s);
    if (frame.id == Wire<RcChannelsOverride>::id || frame.id == Wire<ManualControl>::id)
        override_s_ = now_s;
    if (const auto m = as<ParamSet>(frame)) asked_[nameIn(m->param_id)] = {now_s, m->param_value};
    plan_.sent(frame);
}

}  // namespace simulator::invariants
