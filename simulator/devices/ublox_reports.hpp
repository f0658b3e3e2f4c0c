// SPDX-License-Identifier: GPL-3.0-or-later
// The navigation messages a u-blox module can send, made from one fix.
#pragma once
#include <cstdint>
#include <vector>

#include "simulator/devices/gps_fix.hpp"

namespace simulator {

struct UbloxReport {
    uint8_t message_class, id;
    std::vector<uint8_t> (*bytes)(const GpsFix& fix);  // as they go over the line
};
constexpr int kReportCount = 11;
extern const UbloxReport kReports[kReportCount];

constexpr uint8_t kNmeaClass = 0xF0;

}  // namespace simulator
