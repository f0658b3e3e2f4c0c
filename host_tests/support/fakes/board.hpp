// SPDX-License-Identifier: GPL-3.0-or-later
// The roles of a board, played by doubles.
#pragma once
#include "drivers/mpu6000.hpp"
#include "drivers/ms5611.hpp"
#include "fakes/bus.hpp"
#include "fakes/flash_bus.hpp"

namespace board {

using SensorBus = fakes::Bus;
using ImuSelect = fakes::Pin<0>;
using BarometerSelect = fakes::Pin<1>;

using Inertial = drivers::Mpu6000<SensorBus, ImuSelect>;
using Barometer = drivers::Ms5611<SensorBus, BarometerSelect>;
constexpr bool kCompassUpsideDown = false;

using FlashBus = fakes::FlashBus;
using FlashSelect = fakes::FlashSelect;
using FlashReset = fakes::FlashReset;

using Relay = fakes::Switch<0>;
using LedA = fakes::Switch<1>;
using LedB = fakes::Switch<2>;
using LedC = fakes::Switch<3>;

constexpr uint16_t kLoader_ms = 1165;

constexpr char kName[] = "fake";
constexpr uint8_t kModel = 2;
using ProbeBus = SensorBus;
using ProbeSelect = ImuSelect;

inline void start() {}

}  // namespace board
