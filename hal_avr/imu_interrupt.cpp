// SPDX-License-Identifier: GPL-3.0-or-later
#include "hal/imu_interrupt.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "start.hpp"

namespace avr {

void imuInterruptStart() {
    EIMSK &= static_cast<uint8_t>(~(1 << INT6));  // changing the sense may raise the flag
    EICRB |= (1 << ISC61) | (1 << ISC60);         // rising edge
    EIFR = 1 << INTF6;
    EIMSK |= 1 << INT6;
}

}  // namespace avr

ISR(INT6_vect) {
    if (hal::imuDataReady()) avr::wake();
}
