// SPDX-License-Identifier: GPL-3.0-or-later
// The navigation messages a u-blox module can send, made from one fix.
#pragma once
#include <cstdint>
#include <vector>

namespace simulator {

// One measurement, errors included.
struct GpsFix {
    uint64_t time_us;  // of the measurement
    bool valid;
    int satellites;
    double latitude_deg, longitude_deg, altitude_m;  // above sea level
    double velocity_north_mps, velocity_east_mps, velocity_down_mps;
};

struct UbloxReport {
    uint8_t message_class, id;
    std::vector<uint8_t> (*bytes)(const GpsFix& fix);  // as they go over the line
};
constexpr int kReportCount = 7;
extern const UbloxReport kReports[kReportCount];

constexpr uint8_t kNmeaClass = 0xF0;

}  // namespace simulator
