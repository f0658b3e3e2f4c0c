// SPDX-License-Identifier: GPL-3.0-or-later
// What the live page asks for: the body of POST /command, checked.
#pragma once
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "simulator/devices/faults.hpp"

namespace simulator::live {

struct Order {
    enum class Do { arm, disarm, takeoff, pause, resume, mode, go_to, speed, fault, wind, sticks };
    Do what = Do::pause;
    uint32_t mode = 0;  // ArduPlane's number
    double latitude_deg = 0, longitude_deg = 0;
    std::optional<double> height_m;  // above home; empty: as high as now
    double times = 1;                // real time; 0: as fast as it goes
    Fault fault{};                   // without its times
    std::string fault_name;          // PART:HOW
    bool on = true;                  // the fault begins, else it ends
    double wind_mps = 0, wind_from_deg = 0;
    double roll = 0, pitch = 0, throttle = 0, yaw = 0;  // sticks: -1..1, throttle 0..1
};

// what() is one line for the user.
class OrderError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// Throws OrderError.
Order readOrder(const std::string& json);

// PART:HOW or PART_HOW, as in gps:lost; empty: there is no such fault.
std::optional<Fault> faultNamed(const std::string& name);

std::vector<std::string> modeNames();   // those of this firmware
std::vector<std::string> faultNames();  // without those of the supply's depth

}  // namespace simulator::live
