// SPDX-License-Identifier: GPL-3.0-or-later
// The ground's side of an upload of a mission, a fence or rally points: announces the count until
// the vehicle asks, then answers what it asks for, until its acknowledgement. Times are emulated.
#pragma once
#include <string>

#include "simulator/ground/link.hpp"
#include "simulator/ground/waypoints.hpp"

namespace simulator {

enum class UploadOf : uint8_t { mission = 0, fence = 1, rally = 2 };  // MAV_MISSION_TYPE

class MissionUpload {
public:
    MissionUpload(Link& link, const Waypoints& items, UploadOf type = UploadOf::mission)
        : link_(link), items_(items), type_(type) {}

    void step(uint64_t now_us, uint8_t system, uint8_t component);
    void take(const mavlink::Frame& frame, uint64_t time_us);

    bool accepted() const { return accepted_; }
    const std::string& failure() const { return failure_; }  // empty: none

private:
    void answer(int item, bool as_int, uint64_t time_us);
    template <class Item>
    Item header(const WaypointItem& from) const;

    bool ours(uint8_t type) const { return type == static_cast<uint8_t>(type_); }
    std::string name() const;

    Link& link_;
    const Waypoints& items_;
    const UploadOf type_;
    uint8_t system_ = 0, component_ = 0;
    uint64_t asked_us_ = 0;  // the vehicle's last request, or our last announcement
    int announcements_ = 0;
    int last_item_ = -1;  // asked for last; -1: none yet
    bool accepted_ = false;
    std::string failure_;
};

}  // namespace simulator
