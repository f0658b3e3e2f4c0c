// SPDX-License-Identifier: GPL-3.0-or-later
// Entry and exit of the interrupts written in assembler: r24, r25, r30 and r31 are free in between.
// The lines go on with others, so no comma and no semicolon.
#pragma once
#include <avr/io.h>

// clang-format off
#define ISR_ENTRY                \
    "push r30                \n" \
    "in   r30, __SREG__      \n" \
    "push r30                \n" \
    "push r31                \n" \
    "push r24                \n" \
    "push r25                \n"
#define ISR_UNDO                 \
    "pop  r25                \n" \
    "pop  r24                \n" \
    "pop  r31                \n" \
    "pop  r30                \n" \
    "out  __SREG__, r30      \n" \
    "pop  r30                \n"
#define ISR_EXIT                 \
    ISR_UNDO                     \
    "reti                    \n"
// clang-format on
