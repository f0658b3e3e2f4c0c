// SPDX-License-Identifier: GPL-3.0-or-later
// ArduPilotMega 1 with its sensor shield: which part is wired to which pin. Roles on the left,
// silicon on the right; the peripherals' own pins stand in wiring.hpp.
#pragma once
#include "drivers/ads7844.hpp"
#include "drivers/analog_imu.hpp"
#include "drivers/bmp085.hpp"
#include "pin.hpp"
#include "spi.hpp"
#include "usart_spi.hpp"

namespace board {

using ConverterBus = avr::Usart2Pairs;
using ConverterSelect = avr::Pin<avr::PortC, 4>;
using Converter = drivers::Ads7844<ConverterBus, ConverterSelect>;

using Inertial = drivers::AnalogImu<Converter>;
using Barometer = drivers::Bmp085;
constexpr bool kCompassUpsideDown = true;  // the shield hangs with its parts below

using FlashBus = avr::FlashSpi0;
using FlashSelect = avr::Pin<avr::PortB, 0>;  // AT45DB161D
using FlashReset = avr::Pin<avr::PortC, 6>;

using Relay = avr::Pin<avr::PortL, 2>;
using LedA = avr::ActiveHighLed<avr::Pin<avr::PortC, 0>>;  // red: armed
using LedB = avr::ActiveHighLed<avr::Pin<avr::PortC, 1>>;  // yellow
using LedC = avr::ActiveHighLed<avr::Pin<avr::PortC, 2>>;  // blue: GPS

using SlideSwitch = avr::Pin<avr::PortG, 1>;
using PushButton = avr::Pin<avr::PortG, 0>;

// From a reset to the first instruction: Arduino's bootloader listens for a second, after the 65 ms
// of the fuses. BRD_LOADER_MS.
constexpr uint16_t kLoader_ms = 65 + 1000;

constexpr char kName[] = "APM 1";
constexpr uint8_t kModel = 1;
struct ProbeBus : avr::Spi0 {  // to whatever is at PB0
    static void fast() { FlashBus::start(); }
};
using ProbeSelect = FlashSelect;

// Pins, clock, peripherals; interrupts are on afterwards, the converter's timer runs.
void start();

}  // namespace board
