// SPDX-License-Identifier: GPL-3.0-or-later
// ArduPilotMega 2.x: which part is wired to which pin. Roles on the left, silicon on the right;
// the peripherals' own pins stand in wiring.hpp.
#pragma once
#include "drivers/mpu6000.hpp"
#include "drivers/ms5611.hpp"
#include "pin.hpp"
#include "spi.hpp"
#include "usart_spi.hpp"

namespace board {

using SensorBus = avr::Spi0;
using ImuSelect = avr::Pin<avr::PortB, 0>;        // MPU-6000
using BarometerSelect = avr::Pin<avr::PortG, 1>;  // MS5611
using Inertial = drivers::Mpu6000<SensorBus, ImuSelect>;
using Barometer = drivers::Ms5611<SensorBus, BarometerSelect>;
constexpr bool kCompassUpsideDown = false;

using FlashBus = avr::Usart3Spi;
using FlashSelect = avr::Pin<avr::PortA, 6>;  // AT45DB161D or AT45DB321D
using FlashReset = avr::Pin<avr::PortG, 0>;

using Relay = avr::Pin<avr::PortB, 7>;                    // the A9 pad
using LedA = avr::ActiveLowLed<avr::Pin<avr::PortA, 5>>;  // red: armed
using LedB = avr::ActiveLowLed<avr::Pin<avr::PortA, 4>>;  // yellow
using LedC = avr::ActiveLowLed<avr::Pin<avr::PortA, 3>>;  // blue: GPS

// From a reset to the first instruction: its bootloader without USB waits 400, 200 and 500 ms,
// after the 65 of the fuses. BRD_LOADER_MS.
constexpr uint16_t kLoader_ms = 65 + 400 + 200 + 500;

constexpr char kName[] = "APM 2";
constexpr uint8_t kModel = 2;
using ProbeBus = SensorBus;  // to whatever is at PB0
using ProbeSelect = ImuSelect;

// Pins, clock, peripherals; interrupts are on afterwards, that of the inertial sensor too.
void start();

}  // namespace board
