// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file_state.hpp"
#include "firmware/guidance/bank.hpp"
#include "firmware/guidance/flights.hpp"
#include "firmware/guidance/lateral.hpp"
#include "firmware/guidance/path_state.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace guidance {

using namespace state;

namespace {

core::FileState<navigation::TurnCount> turns{};

}  // namespace

void beginCircling() { turns.start(); }

Plan flyCircle() {
    const auto& demand = vehicle.demand;
    const navigation::Circle circle = {demand.radius_m, demand.counter_clockwise};
    const auto now = motion();
    const geo::Offset from_centre = geo::offset(demand.to, vehicle.estimate.position);
    const auto lateral = navigation::followCircle(lateralGains(), now, circle, from_centre);
    reportLateral(lateral, from_centre);
    demandBank(lateral.bank_accel_mss, BankLimit::flying);
    turns.update(circle, from_centre, lateral.crosstrack_m);
    const float outside_m = lateral.crosstrack_m;
    learnBankTrim(circle.counter_clockwise ? -outside_m : outside_m);
    progress.captured = turns.captured();
    progress.turned_rad = turns.turned_rad();
    Plan to_fly = levelPlan();
    if (!turns.captured())
        followSlope(to_fly, legLength_m() - demand.radius_m, legLength_m() - lateral.distance_m,
                    along_mps(lateral, now));
    return to_fly;
}

}  // namespace guidance
}  // namespace firmware
