// SPDX-License-Identifier: GPL-3.0-or-later
#include "board.hpp"

#include <avr/interrupt.h>

#include "converter.hpp"
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
    deselect<ConverterSelect>();
    // The slave select of SPI0 too: as an input, low, it would end the master's mode.
    deselect<FlashSelect>();
    Relay::low();
    Relay::output();
    LedA::output();
    LedB::output();
    LedC::output();
    SlideSwitch::high();  // switches to ground, pulled up
    PushButton::high();
    ConverterBus::start();
    FlashBus::start();
    avr::clockStart();
    avr::ppmStart();
    avr::serialStart();
    avr::twiStart();
    avr::adcStart();
    converterStart();
    sei();
}

}  // namespace board
