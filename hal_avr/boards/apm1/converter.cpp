// SPDX-License-Identifier: GPL-3.0-or-later
// The ADS7844 between Timer2, which begins a set every millisecond, and the interrupt of its bus.
#include "converter.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <stddef.h>

#include "board.hpp"
#include "wiring.hpp"

// Flat: with a call in it an interrupt saves every register.
ISR(TIMER2_COMPA_vect, __attribute__((flatten))) { board::Converter::beginSet(); }
extern "C" __attribute__((signal, used, flatten)) void __vector_of_last_exchange();
void __vector_of_last_exchange() { board::Converter::onSent(); }

// Eight thousand times a second, seven of eight of them by hand: 85 cycles with entry and exit,
// compiled 131. Does Converter::onSent() for exchanges that another follows. A register is kept
// where no other interrupt looks.
ISR(USART2_TX_vect, ISR_NAKED) {
    using Converter = board::Converter;
    using State = Converter::State;
    const uint8_t* const state = reinterpret_cast<const uint8_t*>(&Converter::state_);
    __asm__ volatile(
        "out  %[keep], r30               \n"
        "in   r30, __SREG__              \n"
        "push r30                        \n"
        "push r31                        \n"
        "lds  r30, %[next]               \n"
        "cpi  r30, %[last]               \n"
        "brsh 4f                         \n"
        "push r24                        \n"
        "push r25                        \n"
        "push r26                        \n"
        "lds  r24, %[data]               \n"  // low
        "lds  r25, %[data]               \n"  // high of the one after it
        "inc  r30                        \n"
        "mov  r26, r30                   \n"
        "sts  %[next], r30               \n"
        "ldi  r31, 0                     \n"
        "subi r30, lo8(-(%[ask]))        \n"
        "sbci r31, hi8(-(%[ask]))        \n"
        "lpm  r30, Z                     \n"
        "ldi  r31, 0                     \n"
        "sts  %[data], r30               \n"
        "sts  %[data], r31               \n"
        "lds  r30, %[high]               \n"
        "sts  %[high], r25               \n"
        "subi r26, 2                     \n"
        "brcs 2f                         \n"  // nothing has ended yet
        "mov  r25, r30                   \n"
        "mov  r30, r24                   \n"
        "andi r30, 0x07                  \n"
        "brne 3f                         \n"
        "sbrc r25, 7                     \n"
        "rjmp 3f                         \n"
        "1:                              \n"
        "lsr  r25                        \n"
        "ror  r24                        \n"
        "lsr  r25                        \n"
        "ror  r24                        \n"
        "lsr  r25                        \n"
        "ror  r24                        \n"
        "mov  r30, r26                   \n"
        "lsl  r30                        \n"
        "subi r30, lo8(-(%[sum]))        \n"
        "sbci r31, hi8(-(%[sum]))        \n"
        "ld   r26, Z                     \n"
        "add  r26, r24                   \n"
        "st   Z, r26                     \n"
        "ldd  r26, Z+1                   \n"
        "adc  r26, r25                   \n"
        "std  Z+1, r26                   \n"
        "2:                              \n"
        "pop  r26                        \n"
        "pop  r25                        \n"
        "pop  r24                        \n"
        "pop  r31                        \n"
        "pop  r30                        \n"
        "out  __SREG__, r30              \n"
        "in   r30, %[keep]               \n"
        "reti                            \n"
        "3:                              \n"  // spoiled
        "ldi  r30, 1                     \n"
        "sts  %[spoiled], r30            \n"
        "rjmp 1b                         \n"
        "4:                              \n"
        "pop  r31                        \n"
        "pop  r30                        \n"
        "out  __SREG__, r30              \n"
        "in   r30, %[keep]               \n"
        "jmp  __vector_of_last_exchange  \n"
        :
        : [next] "i"(state + offsetof(State, next)), [high] "i"(state + offsetof(State, high)),
          [sum] "i"(state + offsetof(State, sum)), [spoiled] "i"(state + offsetof(State, spoiled)),
          [ask] "i"(Converter::kAsk), [last] "M"(int{Converter::kLast}), [data] "i"(&UDR2),
          [keep] "I"(_SFR_IO_ADDR(GPIOR2)));
}

namespace board {

void converterStart() {
    constexpr uint16_t kSteps = F_CPU / 64 * Inertial::kSet_us / 1000000UL;
    static_assert(kSteps <= 256, "Timer2 has 8 bits");
    TCCR2A = 1 << WGM21;
    OCR2A = kSteps - 1;
    TCNT2 = 0;
    TIMSK2 = 1 << OCIE2A;
    TCCR2B = 1 << CS22;  // 4 us a step
}

}  // namespace board

namespace wiring {

hal::AnalogSum airspeed() { return board::Inertial::takeAirspeed(); }

}  // namespace wiring
