// SPDX-License-Identifier: GPL-3.0-or-later
// What there is to see of a flight in one frame of 10 ms, from outside the firmware: the truth, the
// pulses at the pins, the pilot's sticks, and what is wrong with the world.
#pragma once
#include <array>
#include <cstdint>

#include "simulator/devices/faults.hpp"
#include "simulator/world.hpp"

namespace simulator::invariants {

constexpr double kNever_s = -1e9;
constexpr double kDegree = 3.14159265358979323846 / 180;

struct Snapshot {
    uint64_t time_us = 0;
    Truth truth{};
    std::array<double, 8> servo_us{};  // outputs 1..8, 0: silent
    std::array<uint16_t, 8> stick_us{};
    bool transmitting = false;           // and heard by the receiver
    std::array<bool, kFaulty> faulty{};  // sensors that fail now
    bool wide = false;  // the receiver's travel is another than usual: all switches move with it
    bool nine_channels = false;  // in the receiver's frames, instead of eight
    unsigned restarts = 0;       // of the processor since power-on
    uint64_t begun_us = 0;       // when the program's first instruction last ran

    double time_s() const { return static_cast<double>(time_us) * 1e-6; }
};

}  // namespace simulator::invariants
