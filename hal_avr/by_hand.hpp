// SPDX-License-Identifier: GPL-3.0-or-later
// Entry and exit of the interrupts written by hand. They keep three registers where IN and OUT
// reach them, a cycle each where PUSH and POP take two: in registers of the I/O space that serve
// nothing else, among them the compare registers of Timer0, whose matches nobody asks for. Enough
// for all of them, as no interrupt lets another in.
#pragma once
#include <avr/io.h>

// Leaves r30, r31 and r24 free. The lines go on with others, so no comma and no semicolon.
// clang-format off
#define BY_HAND_ENTRY            \
    "out  %[kept_r30], r30   \n" \
    "in   r30, __SREG__      \n" \
    "out  %[kept_flags], r30 \n" \
    "out  %[kept_r31], r31   \n"
#define BY_HAND_UNDO             \
    "in   r31, %[kept_r31]   \n" \
    "in   r30, %[kept_flags] \n" \
    "out  __SREG__, r30      \n" \
    "in   r30, %[kept_r30]   \n"
#define BY_HAND_EXIT             \
    BY_HAND_UNDO                 \
    "reti                    \n"
// clang-format on

// The operands of the above.
#define BY_HAND_KEPT                                                           \
    [kept_r30] "I"(_SFR_IO_ADDR(GPIOR2)), [kept_r31] "I"(_SFR_IO_ADDR(OCR0A)), \
        [kept_flags] "I"(_SFR_IO_ADDR(OCR0B)), [kept_r24] "I"(_SFR_IO_ADDR(GPIOR1))
