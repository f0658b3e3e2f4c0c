// SPDX-License-Identifier: GPL-3.0-or-later
// The ground's side of a download: mission, fence and rally points as the board holds them, one
// list after the other. A list that has changed is asked for again. Times are emulated.
#pragma once
#include <array>

#include "simulator/ground/link.hpp"
#include "simulator/ground/mission_upload.hpp"
#include "simulator/ground/waypoints.hpp"

namespace simulator::live {

constexpr int kLists = 3;  // of MAV_MISSION_TYPE: mission, fence, rally points

class PlanDownload {
public:
    explicit PlanDownload(Link& link) : link_(link) {}

    void step(uint64_t now_us, uint8_t system, uint8_t component);
    void take(const mavlink::Frame& frame, uint64_t now_us);

    void askAgain(int list) { stale_.at(static_cast<size_t>(list)) = true; }
    void askAgain() { stale_.fill(true); }

    // Whether one has been read whole, and which it is. `changes` counts those that differed.
    bool known(int list) const { return known_.at(static_cast<size_t>(list)); }
    const Waypoints& items(int list) const { return lists_.at(static_cast<size_t>(list)); }
    unsigned changes() const { return changes_; }
    bool busy() const { return list_ >= 0; }

private:
    void begin(uint64_t now_us);
    void ask(uint64_t now_us);
    void takeCount(const mavlink::MissionCount& count, uint64_t now_us);
    void takeItem(const mavlink::MissionItemInt& item, uint64_t now_us);
    void finish(bool whole);

    Link& link_;
    uint8_t system_ = 0, component_ = 0;
    std::array<bool, kLists> stale_ = {true, true, true}, known_{};
    std::array<Waypoints, kLists> lists_;
    int list_ = -1;  // which one is asked for; -1: none
    bool counted_ = false;
    size_t count_ = 0;
    Waypoints items_;  // so far
    int tries_ = 0;
    uint64_t asked_us_ = 0, failed_us_ = 0;
    unsigned changes_ = 0;
};

bool sameItems(const Waypoints& a, const Waypoints& b);

}  // namespace simulator::live
