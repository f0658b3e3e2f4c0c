// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/guidance/bank.hpp"

#include <math.h>

#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "firmware/control/attitude_demand.hpp"
#include "firmware/guidance/plan.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"
#include "navigation/l1.hpp"

namespace firmware {
namespace guidance {

using namespace state;
using namespace control;

namespace {

constexpr float kTurnShare = 0.7f;      // of the bank limit, for planned turns
constexpr float kInvertedShare = 0.5f;  // of the bank limit, for a wing the wrong way up
constexpr float kSlowBank_mss = 0.4663f * core::kGravity_mss;  // 25 degrees below flying speed

struct Banking {
    navigation::BankTrim trim;
    float carried_mss;  // see carriedBank_mss
    float turn_accel_mss;
};
core::FileState<Banking> banking{};

float limit_rad(BankLimit limit) {
    if (limit == BankLimit::level) return core::radians(parameters.level_roll_limit_deg);
    const float most_rad = core::fromCentidegrees(parameters.roll_limit_cd);
    return vehicle.inverted ? kInvertedShare * most_rad : most_rad;
}

// The bank whose load the wings still carry at this speed: lift grows with its square.
float carriedBank_mss() {
    if (!vehicle.airspeed.healthy || parameters.stall_prevention == 0) return 1e3f;
    const float ratio = vehicle.estimate.equivalent_airspeed_mps / parameters.speed_min_mps;
    const float load = core::square(ratio);
    const float tangent2 = load * load - 1;
    const float accel_mss = tangent2 > 0 ? core::kGravity_mss * sqrtf(tangent2) : 0;
    return accel_mss > kSlowBank_mss ? accel_mss : kSlowBank_mss;
}

}  // namespace

void beginBanking() {
    banking.trim.start();
    weighBank();
}

void weighBank() { banking.carried_mss = carriedBank_mss(); }

void learnBankTrim(float left_of_path_m) { banking.trim.learn(left_of_path_m, kGuidancePeriod_s); }

void planTurns() {
    banking.turn_accel_mss = kTurnShare * core::kGravity_mss * tanf(limit_rad(BankLimit::flying));
}

float turnAccel_mss() { return banking.turn_accel_mss; }

float presentBank_mss() {
    const float side = vehicle.inverted ? -1 : 1;
    const float cosine = core::limit(vehicle.attitude.cos_roll.toFloat() * side, 0.3f, 1.0f);
    const float tangent =
        core::limit(vehicle.attitude.sin_roll.toFloat() * side / cosine, -2.0f, 2.0f);
    return core::kGravity_mss * tangent - banking.trim.accel_mss();
}

void demandBank(float bank_accel_mss, BankLimit limit) {
    const float most_rad = limit_rad(limit);
    const float accel_mss = core::limit(bank_accel_mss + banking.trim.accel_mss(),
                                        -banking.carried_mss, banking.carried_mss);
    demandRoll(core::Angle(core::limit(navigation::bankFor_rad(accel_mss), -most_rad, most_rad)));
}

}  // namespace guidance
}  // namespace firmware
