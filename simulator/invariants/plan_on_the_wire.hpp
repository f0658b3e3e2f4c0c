// SPDX-License-Identifier: GPL-3.0-or-later
// The mission as the ground stations have sent it and the board has acknowledged it.
#pragma once
#include <map>
#include <optional>
#include <vector>

#include "mavlink/frame.hpp"
#include "mavlink/messages.hpp"
#include "simulator/ground/waypoints.hpp"

namespace simulator::invariants {

struct PlanItem {
    uint16_t command = 0, seq = 0;
    uint8_t frame = 0;
    float params[4] = {}, z = 0;
    int32_t x = 0, y = 0;

    bool isNav() const { return isNavCommand(command); }
};
using Plan = std::vector<PlanItem>;

class PlanOnTheWire {
public:
    void sent(const mavlink::Frame& frame);
    void received(const mavlink::Frame& frame);

    // Empty: nobody here has sent one, or it can not be known which of two was stored.
    const std::optional<Plan>& plan() const { return plan_; }

private:
    void announce(int first, int last, size_t count);
    void item(const PlanItem& item);
    void accept();

    std::optional<Plan> plan_;
    std::map<int, PlanItem> coming_;
    std::optional<size_t> count_;  // announced
    bool partial_ = false, clears_ = false, mixed_ = false;
};

}  // namespace simulator::invariants
