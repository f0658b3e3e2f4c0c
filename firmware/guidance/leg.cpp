// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/guidance/bank.hpp"
#include "firmware/guidance/flights.hpp"
#include "firmware/guidance/lateral.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace guidance {

Plan flyLeg() {
    const auto now = motion();
    const auto lateral = followDemandedLeg(now, true);
    demandBank(lateral.bank_accel_mss, BankLimit::flying);
    Plan to_fly = levelPlan();
    followSlope(to_fly, legLength_m(), lateral.along_m, along_mps(lateral, now));
    return to_fly;
}

}  // namespace guidance
}  // namespace firmware
