// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/invariants/plan_on_the_wire.hpp"

#include <utility>

#include "simulator/ground/link.hpp"

namespace simulator::invariants {

using namespace mavlink;

namespace {

constexpr double kDegreeE7 = 1e7;
constexpr uint8_t kMissionType = 0;

template <class Item>
PlanItem planItem(const Item& from, int32_t x, int32_t y) {
    PlanItem to;
    to.command = from.command;
    to.seq = from.seq;
    to.frame = from.frame;
    to.params[0] = from.param1;
    to.params[1] = from.param2;
    to.params[2] = from.param3;
    to.params[3] = from.param4;
    to.x = x;
    to.y = y;
    to.z = from.z;
    return to;
}

int32_t degreesE7(float degrees) { return static_cast<int32_t>(double(degrees) * kDegreeE7); }

}  // namespace

// A second announcement while one is being answered: which one the board stores is its own affair.
void PlanOnTheWire::announce(int, int, size_t count) {
    mixed_ = mixed_ || (count_.has_value() && *count_ != count && !coming_.empty());
    count_ = count;
    coming_.clear();
    clears_ = false;
}

void PlanOnTheWire::item(const PlanItem& item) {
    const auto known = coming_.find(item.seq);
    const bool differs = known != coming_.end() &&
                         (known->second.command != item.command || known->second.x != item.x);
    mixed_ = mixed_ || differs;
    coming_[item.seq] = item;
    // Whole, or of an upload whose announcement another station's answer seemed to end: stored or
    // not, as an answer will say that may go to a link nobody listens to.
    if (!count_ || coming_.size() == *count_) plan_.reset();
}

void PlanOnTheWire::sent(const Frame& frame) {
    if (const auto count = as<MissionCount>(frame))
        if (count->mission_type == kMissionType) partial_ = false, announce(0, 0, count->count);
    if (const auto part = as<MissionWritePartialList>(frame))
        if (part->mission_type == kMissionType) {
            announce(part->start_index, part->end_index, 0);
            partial_ = true;
        }
    if (const auto clear = as<MissionClearAll>(frame))
        if (clear->mission_type == kMissionType || clear->mission_type == 255) {
            mixed_ = mixed_ || !coming_.empty();
            clears_ = true;
            count_ = 0;
        }
    if (const auto each = as<MissionItemInt>(frame))
        if (each->mission_type == kMissionType) item(planItem(*each, each->x, each->y));
    if (const auto each = as<MissionItem>(frame))
        if (each->mission_type == kMissionType)
            item(planItem(*each, degreesE7(each->x), degreesE7(each->y)));
}

void PlanOnTheWire::received(const Frame& frame) {
    const auto ack = as<MissionAck>(frame);
    if (!ack || ack->mission_type != kMissionType || !count_) return;
    if (ack->type == MavMissionResult::accepted) {
        accept();
    } else if (ack->type != MavMissionResult::accepted) {
        mixed_ = false;
    }
    coming_.clear();
    count_.reset();
    clears_ = false;
}

void PlanOnTheWire::accept() {
    const bool whole = coming_.size() == *count_;
    if (std::exchange(mixed_, false) || partial_ || (!clears_ && !whole)) {
        plan_.reset();
        return;
    }
    plan_.emplace();
    if (clears_) return;
    for (const auto& [seq, item] : coming_) plan_->push_back(item);
}

}  // namespace simulator::invariants
