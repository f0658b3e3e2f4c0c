// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/plan_download.hpp"

#include <algorithm>
#include <tuple>

namespace simulator::live {
namespace {

using namespace mavlink;

constexpr uint64_t kAgain_us = 1'000'000, kRest_us = 5'000'000;
constexpr int kTries = 5;
constexpr uint8_t kAccepted = 0;  // MAV_MISSION_RESULT

WaypointItem waypoint(const MissionItemInt& from) {
    WaypointItem to;
    to.index = from.seq;
    to.current = from.current != 0;
    to.frame = from.frame;
    to.command = from.command;
    to.params = {from.param1, from.param2, from.param3, from.param4};
    to.latitude_deg = from.x / 1e7;
    to.longitude_deg = from.y / 1e7;
    to.altitude_m = from.z;
    to.autocontinue = from.autocontinue != 0;
    return to;
}

}  // namespace

// What is drawn of them; NaN of a parameter is no difference.
bool sameItems(const Waypoints& a, const Waypoints& b) {
    const auto drawn = [](const WaypointItem& item) {
        return std::make_tuple(item.index, item.frame, item.command, item.latitude_deg,
                               item.longitude_deg, item.altitude_m);
    };
    const auto same = [&](const WaypointItem& x, const WaypointItem& y) {
        for (size_t i = 0; i < x.params.size(); ++i)
            if (x.params[i] != y.params[i] &&
                !(x.params[i] != x.params[i] && y.params[i] != y.params[i]))
                return false;
        return drawn(x) == drawn(y);
    };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

void PlanDownload::step(uint64_t now_us, uint8_t system, uint8_t component) {
    system_ = system;
    component_ = component;
    if (list_ < 0) return begin(now_us);
    if (now_us - asked_us_ < kAgain_us) return;
    if (tries_ < kTries) return ask(now_us);
    failed_us_ = now_us;
    finish(false);
}

void PlanDownload::begin(uint64_t now_us) {
    if (failed_us_ != 0 && now_us - failed_us_ < kRest_us) return;
    const auto next = std::find(stale_.begin(), stale_.end(), true);
    if (next == stale_.end()) return;
    list_ = static_cast<int>(next - stale_.begin());
    *next = false;
    counted_ = false;
    items_.clear();
    tries_ = 0;
    ask(now_us);
}

void PlanDownload::ask(uint64_t now_us) {
    asked_us_ = now_us;
    ++tries_;
    const auto send = [this](auto message) {
        message.target_system = system_;
        message.target_component = component_;
        message.mission_type = static_cast<uint8_t>(list_);
        link_.send(message);
    };
    if (!counted_) return send(MissionRequestList{});
    MissionRequestInt request{};
    request.seq = static_cast<uint16_t>(items_.size());
    send(request);
}

void PlanDownload::take(const Frame& frame, uint64_t now_us) {
    if (list_ < 0) return;
    if (const auto count = as<MissionCount>(frame)) takeCount(*count, now_us);
    if (const auto item = as<MissionItemInt>(frame)) takeItem(*item, now_us);
}

void PlanDownload::takeCount(const MissionCount& count, uint64_t now_us) {
    if (counted_ || count.mission_type != list_) return;
    counted_ = true;
    count_ = count.count;
    tries_ = 0;
    if (count_ == 0) return finish(true);
    ask(now_us);
}

void PlanDownload::takeItem(const MissionItemInt& item, uint64_t now_us) {
    if (!counted_ || item.mission_type != list_ || item.seq != items_.size()) return;
    items_.push_back(waypoint(item));
    tries_ = 0;
    if (items_.size() < count_) return ask(now_us);
    finish(true);
}

// One that broke off is asked for again later; the list that was known stays until then.
void PlanDownload::finish(bool whole) {
    const auto list = static_cast<size_t>(list_);
    list_ = -1;
    if (!whole) {
        stale_[list] = true;
        return;
    }
    MissionAck ack{};
    ack.target_system = system_;
    ack.target_component = component_;
    ack.type = kAccepted;
    ack.mission_type = static_cast<uint8_t>(list);
    link_.send(ack);
    if (!known_[list] || !sameItems(lists_[list], items_)) ++changes_;
    known_[list] = true;
    lists_[list] = std::move(items_);
    items_ = {};
}

}  // namespace simulator::live
