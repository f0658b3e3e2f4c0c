; SPDX-License-Identifier: GPL-3.0-or-later
; What fixed point makes of 32 bits again and again: the upper half, rounded, of 4 and of 16 times a
; number, and of such multiples of a product. Loops of shifts and roundings in line take half as long
; again and 20 bytes each. In: a number in r25..r22, or two in r25 r24 and r23 r22. Out: r25 r24.

    .section .text.libgcc.upper, "ax", @progbits
    .global multiplyTimes12
    .type   multiplyTimes12, @function
    .global multiplyTimes14
    .type   multiplyTimes14, @function
    .global upperTimes4
    .type   upperTimes4, @function
    .global upperTimes16
    .type   upperTimes16, @function

    .macro double
    lsl  r22
    rol  r23
    rol  r24
    rol  r25
    .endm

multiplyTimes14:
    movw r26, r24
    movw r18, r22
    call __mulhisi3
    rjmp upperTimes4
multiplyTimes12:
    movw r26, r24
    movw r18, r22
    call __mulhisi3
upperTimes16:
    double
    double
upperTimes4:
    double
    double
    lsl  r23                ; the half below
    adc  r24, r1
    adc  r25, r1
    ret
    .size multiplyTimes14, . - multiplyTimes14
