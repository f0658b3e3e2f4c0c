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
constexpr float kBankLoop_s = 0.1f;     // what servo and airframe add to RLL2SRV_TCONST
constexpr float kSlowBank_mss = 0.4663f * core::kGravity_mss;  // 25 degrees below flying speed

constexpr float kDrawn = kGuidancePeriod_s / 0.7f;  // see expectBank

struct Banking {
    navigation::BankTrim trim;
    float carried_mss;   // see carriedBank_mss
    float expected_mss;  // see expectBank
    float follows;       // of the demanded bank, in one run
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
    const float ratio = vehicle.estimate.equivalent_airspeed_mps / speedMin_mps();
    const float load = core::square(ratio);
    const float tangent2 = load * load - 1;
    const float accel_mss = core::isPositive(tangent2) ? core::kGravity_mss * sqrtf(tangent2) : 0;
    return accel_mss > kSlowBank_mss ? accel_mss : kSlowBank_mss;
}

// As whole numbers of the same scale, 20 times a second.
float measuredBank_tan() {
    constexpr int16_t kLeastCosine = core::Ratio(0.3f).raw;
    int16_t sine = vehicle.attitude.sin_roll.raw, cosine = vehicle.attitude.cos_roll.raw;
    if (vehicle.inverted) {
        sine = -sine;
        cosine = -cosine;
    }
    if (cosine < kLeastCosine) cosine = kLeastCosine;
    return core::limit(core::real(sine) / core::real(cosine), -2.0f, 2.0f);
}

// The bank as the demands so far will have brought it about. The measured one, fed back beside the
// loop that flies it, makes that loop as many times quicker as a turn is led: too quick for wings
// that roll slowly. It draws the expected one within a second.
void expectBank(float demanded_mss) {
    const float expected_mss = banking.expected_mss;
    banking.expected_mss += (demanded_mss - expected_mss) * banking.follows +
                            (measuredBank_tan() * core::kGravity_mss - expected_mss) * kDrawn;
}

}  // namespace

float bankLag_s() { return parameters.roll.axis.time_constant_s + kBankLoop_s; }

float expectedBank_mss() { return banking.expected_mss - banking.trim.accel_mss(); }

void beginBanking() {
    banking.trim.start();
    banking.expected_mss = core::kGravity_mss * measuredBank_tan();
    weighBank();
}

void weighBank() { banking.carried_mss = carriedBank_mss(); }

void learnBankTrim(float left_of_path_m) { banking.trim.learn(left_of_path_m, kGuidancePeriod_s); }

void planTurns() {
    banking.follows = kGuidancePeriod_s / bankLag_s();
    banking.turn_accel_mss = kTurnShare * core::kGravity_mss * tanf(limit_rad(BankLimit::flying));
}

float turnAccel_mss() { return banking.turn_accel_mss; }
float mostBank_mss() { return banking.turn_accel_mss * (1 / kTurnShare); }

void demandBank(float bank_accel_mss, BankLimit limit) {
    const float most_rad = limit_rad(limit);
    const float accel_mss = core::limit(bank_accel_mss + banking.trim.accel_mss(),
                                        -banking.carried_mss, banking.carried_mss);
    demandRoll(core::Angle(core::limit(navigation::bankFor_rad(accel_mss), -most_rad, most_rad)));
    const float most_mss = limit == BankLimit::level
                               ? core::kGravity_mss * most_rad  // a small angle
                               : mostBank_mss();
    expectBank(core::limit(accel_mss, -most_mss, most_mss));
}

}  // namespace guidance
}  // namespace firmware
