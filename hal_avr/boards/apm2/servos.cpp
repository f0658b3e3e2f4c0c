// SPDX-License-Identifier: GPL-3.0-or-later
#include <avr/interrupt.h>

#include "pwm.hpp"
#include "wiring.hpp"

ISR(TIMER1_COMPA_vect) { avr::endServo<1, 'A'>(); }
ISR(TIMER1_COMPB_vect) { avr::endServo<1, 'B'>(); }
ISR(TIMER3_COMPA_vect) { avr::endServo<3, 'A'>(); }
ISR(TIMER3_COMPB_vect) { avr::endServo<3, 'B'>(); }
ISR(TIMER3_COMPC_vect) { avr::endServo<3, 'C'>(); }
ISR(TIMER4_COMPA_vect) { avr::endServo<4, 'A'>(); }
ISR(TIMER4_COMPB_vect) { avr::endServo<4, 'B'>(); }
ISR(TIMER4_COMPC_vect) { avr::endServo<4, 'C'>(); }

namespace avr {

void servoTimersStart(uint16_t top) {
    startServoTimer<1, 'A', 'B'>(top);
    startServoTimer<3, 'A', 'C'>(top);
    startServoTimer<4, 'A', 'C'>(top);
    Pin<PortB, 6>::output();
    Pin<PortB, 5>::output();
    Pin<PortE, 5>::output();
    Pin<PortE, 4>::output();
    Pin<PortE, 3>::output();
    Pin<PortH, 5>::output();
    Pin<PortH, 4>::output();
    Pin<PortH, 3>::output();
}

}  // namespace avr
