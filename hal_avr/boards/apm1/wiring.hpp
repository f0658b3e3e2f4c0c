// SPDX-License-Identifier: GPL-3.0-or-later
// ArduPilotMega 1: which of the chip's peripherals plays which part, for hal_avr's own sources.
#pragma once
#include "analog_step.hpp"
#include "core/rom.hpp"
#include "hal/analog.hpp"
#include "pin.hpp"
#include "pwm.hpp"

// avr-libc knows interrupts by the preprocessor alone.
#define CLOCK_OVERFLOW_vect TIMER4_OVF_vect
#define CLOCK_COMPARE_A_vect TIMER4_COMPA_vect
#define CLOCK_CAPTURE_vect TIMER4_CAPT_vect
#define LINK1_RECEIVED_vect USART3_RX_vect
#define LINK1_EMPTY_vect USART3_UDRE_vect

namespace wiring {

constexpr uint8_t kClockTimer = 4;  // the receiver's pulses come in on its ICP4, PL0

// USART0 is the USB plug and nothing else: no pin says whether it is used.
struct AlwaysUsb {
    static void high() {}
    static bool isHigh() { return false; }
};
constexpr uint8_t kLink1Usart = 3;
using Link1Receive = avr::Pin<avr::PortJ, 0>;
using UsbSense = AlwaysUsb;

// Its bootloader leaves the watchdog on after such a reset and would be reset for ever.
constexpr bool kWatchdogResets = false;

constexpr uint8_t kI2cUsers = 2;  // compass and barometer

// clang-format off
constexpr avr::ServoPin kServos[] ROM = {
    avr::servoOn<5>('B'),  // PL4
    avr::servoOn<5>('C'),  // PL5
    avr::servoOn<1>('B'),  // PB6
    avr::servoOn<1>('C'),  // PB7
    avr::servoOn<4>('C'),  // PH5, on the clock's timer
    avr::servoOn<4>('B'),  // PH4, too
    avr::servoOn<3>('C'),  // PE5
    avr::servoOn<3>('B'),  // PE4
};
constexpr bool kServosOnClock = true;

constexpr avr::AnalogStep kAnalogSteps[] ROM = {
    // input              mux  drop take
    {/* airspeed     */  0x00,   0,   0},  // on the ADS7844, never converted here
    {/* voltage A0   */  0x00,   1,   1},
    {/* current A1   */  0x01,   1,   1},
    {/* band gap     */  0x1E,   3,   1},  // a weak source: 1.1 V through the multiplexer
};
// clang-format on
constexpr uint8_t kFirstAnalogStep = 1;
hal::AnalogSum airspeed();  // what the ADS7844 has of it
constexpr uint8_t kAnalogPins0 = (1 << ADC0D) | (1 << ADC1D), kAnalogPins2 = 0;

}  // namespace wiring
