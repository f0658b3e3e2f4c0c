// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/control/attitude_demand.hpp"

#include "firmware/state/published.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<AttitudeDemand> : Writable<AttitudeDemand> {
    using Writable::state;
};
}  // namespace state

namespace control {

using namespace state;

namespace {

constexpr AttitudeDemand& published = Publisher<AttitudeDemand>::state();

}  // namespace

void demandRoll(core::Angle bank_rad) { published.roll_demand_rad = bank_rad; }
void demandPitch(core::Angle pitch_rad) { published.pitch_demand_rad = pitch_rad; }
void demandThrottle(core::Ratio throttle) { published.throttle_demand = throttle; }
void demandRudder(core::Ratio deflection) { published.rudder_demand = deflection; }

}  // namespace control
}  // namespace firmware
