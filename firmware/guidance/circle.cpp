// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "core/seldom.hpp"
#include "firmware/guidance/bank.hpp"
#include "firmware/guidance/flights.hpp"
#include "firmware/guidance/height.hpp"
#include "firmware/guidance/lateral.hpp"
#include "firmware/guidance/path_state.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace guidance {

using namespace notify;
using namespace state;

namespace {

// A circle that is only a little too tight is flown as it was asked for: the bank limit lets it go
// by a few metres where the wind is from behind.
constexpr float kTooTight = 1.1f;

struct Circling {
    navigation::TurnCount turns;
    bool widened;  // reported
};
core::FileState<Circling> circling{};

// What the bank limit flies with the wind from behind.
float tightestRadius_m(float airspeed_mps) {
    const auto& wind_mps = vehicle.estimate.wind_mps;
    const float fastest_mps = airspeed_mps + geo::length_m({wind_mps.x, wind_mps.y});
    return core::square(fastest_mps) / mostBank_mss();
}

// Of the circle flown: the one asked for, unless that is too tight. Out of the large frame of
// flyCircle, which costs twice the flash.
SELDOM float radius_m(float airspeed_mps) {
    const float asked_m = vehicle.demand.radius_m;
    const float tightest_m = tightestRadius_m(airspeed_mps);
    if (tightest_m < kTooTight * asked_m) return asked_m;
    if (!circling.widened) sendStatusText(Severity::warning, STATUS_TEXT("Circle widened"));
    circling.widened = true;
    return tightest_m;
}

}  // namespace

void beginCircling() { circling = {}; }

Plan flyCircle() {
    const auto& demand = vehicle.demand;
    auto& turns = circling.turns;
    Plan to_fly = levelPlan();
    const navigation::Circle circle = {radius_m(to_fly.airspeed_mps * trueFromEquivalent()),
                                       demand.counter_clockwise};
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
    if (!turns.captured())
        followSlope(to_fly, legLength_m() - circle.radius_m, legLength_m() - lateral.distance_m,
                    along_mps(lateral, now));
    return to_fly;
}

}  // namespace guidance
}  // namespace firmware
