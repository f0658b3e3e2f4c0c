// SPDX-License-Identifier: GPL-3.0-or-later
// The ADS7844 between Timer2, which begins a set every millisecond, and the interrupt of its bus.
#include "converter.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <stddef.h>

#include "board.hpp"
#include "isr_asm.hpp"
#include "start.hpp"
#include "wiring.hpp"

// Flat: with a call in it an interrupt saves every register.
extern "C" __attribute__((signal, used, flatten)) void __vector_of_other_sets();
void __vector_of_other_sets() {
    board::Converter::beginSet();
    avr::wake();
}

namespace {

using Converter = board::Converter;
using State = Converter::State;
const uint8_t* const state = reinterpret_cast<const uint8_t*>(&Converter::state_);

static_assert(sizeof(State) <= Converter::kStateAlignment,
              "one block, whose addresses' upper byte is one");
static_assert((Converter::kAirspeedEvery & (Converter::kAirspeedEvery - 1)) == 0,
              "bits of the count below");

}  // namespace

// Both by hand, as the pairs come 6,000 times a second: 69 cycles with entry and exit, and the sets
// 92, compiled nearly twice that. They do Converter::onSent() and beginSet(), the latter but where
// something begins, ends or is wrong.
// clang-format off
#define PAIR_EXIT                        \
    "2:                              \n" \
    ISR_EXIT                             \
    "3:                              \n" \
    "ldi  r30, 1                     \n" \
    "sts  %[invalid], r30            \n" \
    "rjmp 2b                         \n"
#define PAIR_OPERANDS                                                                          \
    [asked] "i"(state + offsetof(State, asked)), [high] "i"(state + offsetof(State, high)),    \
    [invalid] "i"(state + offsetof(State, invalid)), [data] "i"(&UDR2),                        \
    [control] "i"(&UCSR2B), [ask] "M"(int{Converter::kAsk}),                                   \
    [airspeed] "M"(int{Converter::kAirspeed}), [last] "M"(int{Converter::kLast}),              \
    [rest] "M"(int{Converter::kRest})

ISR(TIMER2_COMPA_vect, ISR_NAKED) {
    __asm__ volatile(
        ISR_ENTRY
        "lds  r24, %[status]             \n"
        "lds  r25, %[asked]              \n"
        "lds  r30, %[sets]               \n"
        "sbrs r24, %[ended]              \n"
        "rjmp 4f                         \n"
        "cpi  r25, %[last]               \n"
        "brne 4f                         \n"
        "cpi  r30, %[full] - 1           \n"
        "brsh 4f                         \n"
        "inc  r30                        \n"
        "sts  %[sets], r30               \n"
        "cpi  r30, %[due]                \n"
        "brne 0f                         \n"
        "ldi  r31, 0                     \n"  // avr::wake(): a frame is due
        "out  %[sleep], r31              \n"
        "0:                              \n"
        "lds  r24, %[data]               \n"
        "ldi  r31, 1 << %[ended]         \n"
        "sts  %[status], r31             \n"
        "ldi  r31, %[waking]             \n"
        "sts  %[control], r31            \n"
        "ldi  r31, %[ask]                \n"
        "andi r30, %[every] - 1          \n"
        "brne 1f                         \n"
        "ldi  r31, %[airspeed]           \n"
        "1:                              \n"
        "sts  %[data], r31               \n"
        "sts  %[asked], r31              \n"
        "ldi  r31, %[rest]               \n"
        "sts  %[data], r31               \n"
        "lds  r25, %[sum]                \n"
        "add  r25, r24                   \n"
        "sts  %[sum], r25                \n"
        "lds  r24, %[high]               \n"
        "lds  r25, %[sum]+1              \n"
        "adc  r25, r24                   \n"
        "sts  %[sum]+1, r25              \n"
        "lds  r25, %[data]               \n"
        "sts  %[high], r25               \n"
        "cpi  r24, 0x10                  \n"
        "brsh 3f                         \n"
        PAIR_EXIT
        "4:                              \n"
        ISR_UNDO
        "jmp  __vector_of_other_sets     \n"
        :
        : [sum] "i"(state + offsetof(State, sum) + 2 * drivers::Ads7844Sums::rate_x),
          [sets] "i"(state + offsetof(State, sets)), [full] "M"(int{Converter::kFull}),
          [every] "M"(int{Converter::kAirspeedEvery}), [due] "M"(int{board::Inertial::kUsual}),
          [sleep] "I"(_SFR_IO_ADDR(SMCR)), [status] "i"(&UCSR2A), [ended] "M"(TXC2),
          [waking] "M"(int{board::ConverterBus::kWaking}), PAIR_OPERANDS);
}

ISR(USART2_TX_vect, ISR_NAKED) {
    __asm__ volatile(
        ISR_ENTRY
        "lds  r30, %[asked]              \n"
        "lds  r24, %[data]               \n"
        "subi r30, 0xFE                  \n"
        "cpi  r30, %[gap]                \n"
        "brsh 4f                         \n"
        "sts  %[data], r30               \n"
        "sts  %[asked], r30              \n"
        "1:                              \n"
        "ldi  r31, %[rest]               \n"
        "sts  %[data], r31               \n"
        "ldi  r31, hi8(%[state])         \n"
        "subi r30, lo8(-(%[sums]))       \n"
        "ld   r25, Z                     \n"
        "add  r25, r24                   \n"
        "st   Z, r25                     \n"
        "lds  r24, %[high]               \n"
        "ldd  r25, Z+1                   \n"
        "adc  r25, r24                   \n"
        "std  Z+1, r25                   \n"
        "lds  r25, %[data]               \n"
        "sts  %[high], r25               \n"
        "cpi  r24, 0x10                  \n"
        "brsh 3f                         \n"
        PAIR_EXIT
        "4:                              \n"
        "brne 5f                         \n"
        "ldi  r25, %[resting]            \n"
        "sts  %[control], r25            \n"
        "ldi  r25, %[last]               \n"
        "rjmp 7f                         \n"
        "5:                              \n"
        "cpi  r30, %[airspeed] + 2       \n"
        "brne 6f                         \n"
        "ldi  r30, %[ask] + 2            \n"
        "ldi  r25, %[after]              \n"
        "rjmp 7f                         \n"
        "6:                              \n"
        "ldi  r30, %[airspeed]           \n"
        "lds  r25, %[airspeeds]          \n"
        "inc  r25                        \n"
        "sts  %[airspeeds], r25          \n"
        "ldi  r25, %[ask] + 2            \n"
        "7:                              \n"
        "sts  %[asked], r25              \n"
        "andi r25, 0x1F                  \n"
        "sts  %[data], r25               \n"
        "rjmp 1b                         \n"
        :
        : [state] "i"(state), [sums] "i"(state + offsetof(State, sum) - (Converter::kAsk + 2)),
          [airspeeds] "i"(state + offsetof(State, airspeeds)), [gap] "M"(int{Converter::kGap}),
          [after] "M"(int{Converter::kAfterAirspeed}),
          [resting] "M"(int{board::ConverterBus::kResting}), PAIR_OPERANDS);
}
// clang-format on

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
