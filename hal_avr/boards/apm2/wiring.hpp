// SPDX-License-Identifier: GPL-3.0-or-later
// ArduPilotMega 2.x: which of the chip's peripherals plays which part, for hal_avr's own sources.
#pragma once
#include "analog_step.hpp"
#include "core/rom.hpp"
#include "hal/analog.hpp"
#include "pin.hpp"
#include "pwm.hpp"

// avr-libc knows interrupts by the preprocessor alone.
#define CLOCK_OVERFLOW_vect TIMER5_OVF_vect
#define CLOCK_COMPARE_A_vect TIMER5_COMPA_vect
#define CLOCK_CAPTURE_vect TIMER5_CAPT_vect
#define LINK1_RECEIVED_vect USART2_RX_vect
#define LINK1_EMPTY_vect USART2_UDRE_vect

namespace wiring {

constexpr uint8_t kClockTimer = 5;  // the receiver's pulses come in on its ICP5, PL1

constexpr uint8_t kLink1Usart = 2;
using Link1Receive = avr::Pin<avr::PortH, 0>;
using UsbSense = avr::Pin<avr::PortA, 1>;  // low while USB is plugged in

constexpr bool kWatchdogResets = true;  // its bootloader then passes on at once

constexpr uint8_t kI2cUsers = 1;  // the compass

// clang-format off
constexpr avr::ServoPin kServos[] ROM = {
    avr::servoOn<1>('B'),  // PB6
    avr::servoOn<1>('A'),  // PB5
    avr::servoOn<4>('C'),  // PH5
    avr::servoOn<4>('B'),  // PH4
    avr::servoOn<4>('A'),  // PH3
    avr::servoOn<3>('C'),  // PE5
    avr::servoOn<3>('B'),  // PE4
    avr::servoOn<3>('A'),  // PE3
};
constexpr bool kServosOnClock = false;

constexpr avr::AnalogStep kAnalogSteps[] ROM = {
    // input              mux  drop take
    {/* airspeed A0  */  0x00,   1,   4},
    {/* voltage A13  */  0x25,   1,   1},
    {/* current A12  */  0x24,   1,   1},
    {/* band gap     */  0x1E,   3,   1},  // a weak source: 1.1 V through the multiplexer
};
// clang-format on
constexpr uint8_t kFirstAnalogStep = 0;
inline hal::AnalogSum airspeed() { return {0, 0}; }
constexpr uint8_t kAnalogPins0 = 1 << ADC0D, kAnalogPins2 = (1 << ADC12D) | (1 << ADC13D);

}  // namespace wiring
