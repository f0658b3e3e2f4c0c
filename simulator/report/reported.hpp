// SPDX-License-Identifier: GPL-3.0-or-later
// What the autopilot says of itself at a moment, as far as it has said it.
#pragma once
#include <array>
#include <optional>

#include "simulator/ground/telemetry.hpp"

namespace simulator {

struct Reported {
    using Value = std::optional<double>;
    Value latitude_deg, longitude_deg;
    Value ground_speed_mps, climb_mps, throttle_percent;
    Value height_demand_m, airspeed_demand_mps, bearing_demand_deg, crosstrack_m;
    Value wind_mps, wind_from_deg;
    Value battery_v, battery_a, battery_percent, board_v, load_percent;
    Value satellites, fix, hdop, gps_speed_mps, gps_course_deg;
    Value gyro_dps[3], acceleration_mss[3];
    std::array<Value, 8> rc_us;
};

Reported reportedBy(const Telemetry& telemetry);

}  // namespace simulator
