// SPDX-License-Identifier: GPL-3.0-or-later
#include "board.hpp"

#include <avr/interrupt.h>

#include "start.hpp"

namespace board {

namespace {

template <class Select>
void deselect() {
    Select::high();
    Select::output();
}

}  // namespace

void start() {
    cli();
    // The inertial sensor's select is to be high before the barometer's is touched, or the
    // barometer does not come up.
    deselect<ImuSelect>();
    deselect<BarometerSelect>();
    deselect<FlashSelect>();
    Relay::low();
    Relay::output();
    LedA::output();
    LedB::output();
    LedC::output();
    SensorBus::start();
    FlashBus::start();
    avr::clockStart();
    avr::ppmStart();
    avr::serialStart();
    avr::twiStart();
    avr::adcStart();
    avr::imuInterruptStart();
    sei();
}

}  // namespace board
