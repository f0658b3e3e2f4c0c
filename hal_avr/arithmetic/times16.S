; SPDX-License-Identifier: GPL-3.0-or-later
; Without it the processor is busy 3.5 % more (docs/measurements.md).
; core::times16: the upper 32 of the 48 bits of a product, in a third of what the compiler's takes.
; In: r25..r22 and r21..r20, least byte lowest. Out: r25..r22.

    .section .text.libgcc.times16, "ax", @progbits
    .global multiplyTimes16
    .type   multiplyTimes16, @function
multiplyTimes16:
    clr  r26
    movw r18, r24
    mul  r22, r20
    mov  r27, r1        ; then into r25 r24 r31 r30 r27
    mul  r18, r20
    movw r30, r0
    muls r19, r21
    movw r24, r0
    mul  r23, r20
    add  r27, r0
    adc  r30, r1
    adc  r31, r26
    adc  r24, r26
    adc  r25, r26
    mulsu r21, r22
    sbc  r26, r26       ; the sign
    add  r27, r0
    adc  r30, r1
    adc  r31, r26
    adc  r24, r26
    adc  r25, r26
    mulsu r21, r23
    sbc  r26, r26
    add  r30, r0
    adc  r31, r1
    adc  r24, r26
    adc  r25, r26
    clr  r26
    mulsu r21, r18
    sbc  r25, r26
    add  r31, r0
    adc  r24, r1
    adc  r25, r26
    mulsu r19, r20
    sbc  r25, r26
    add  r31, r0
    adc  r24, r1
    adc  r25, r26
    movw r22, r30
    clr  r1
    ret
    .size multiplyTimes16, . - multiplyTimes16
