// SPDX-License-Identifier: GPL-3.0-or-later
#include <avr/interrupt.h>

#include "clock_pulses.hpp"
#include "pwm.hpp"
#include "wiring.hpp"

ISR(TIMER1_COMPB_vect) { avr::endServo<1, 'B'>(); }
ISR(TIMER1_COMPC_vect) { avr::endServo<1, 'C'>(); }
ISR(TIMER3_COMPB_vect) { avr::endServo<3, 'B'>(); }
ISR(TIMER3_COMPC_vect) { avr::endServo<3, 'C'>(); }
ISR(TIMER5_COMPB_vect) { avr::endServo<5, 'B'>(); }
ISR(TIMER5_COMPC_vect) { avr::endServo<5, 'C'>(); }
ISR(TIMER4_COMPB_vect) { avr::clockPulseEdge<'B'>(); }
ISR(TIMER4_COMPC_vect) { avr::clockPulseEdge<'C'>(); }

namespace avr {

void servoTimersStart(uint16_t top) {
    startServoTimer<1, 'B', 'C'>(top);
    startServoTimer<3, 'B', 'C'>(top);
    startServoTimer<5, 'B', 'C'>(top);
    clockPulsesStart(top + 1);
    forceServosLow<4, 'B', 'C'>();
    Pin<PortL, 4>::output();
    Pin<PortL, 5>::output();
    Pin<PortB, 6>::output();
    Pin<PortB, 7>::output();
    Pin<PortH, 5>::output();
    Pin<PortH, 4>::output();
    Pin<PortE, 5>::output();
    Pin<PortE, 4>::output();
}

}  // namespace avr
