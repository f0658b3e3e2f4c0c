; SPDX-License-Identifier: GPL-3.0-or-later
; core::times14 and core::times12: 4 and 16 times the product of 16 bits, its upper half rounded. What
; the compiler makes of either is as quick, but stands at each of 50 places.
; In: r25 r24 and r23 r22. Out: r25 r24.

    .macro quadruple    ; r25 r24 r19 r18
    .rept 2
    lsl  r18
    rol  r19
    rol  r24
    rol  r25
    .endr
    .endm

    .section .text.libgcc.times14, "ax", @progbits
    .global multiplyTimes12
    .type   multiplyTimes12, @function
multiplyTimes12:
    rcall 1f
    quadruple
    rjmp 2f
    .size multiplyTimes12, . - multiplyTimes12

    .global multiplyTimes14
    .type   multiplyTimes14, @function
multiplyTimes14:
    rcall 1f
2:  quadruple
    subi r19, 0x80      ; the half
    sbci r24, 0xFF
    sbci r25, 0xFF
    ret
1:  movw r20, r24
    clr  r26            ; the product into r25 r24 r19 r18
    muls r21, r23
    movw r24, r0
    mul  r20, r22
    movw r18, r0
    mulsu r21, r22
    sbc  r25, r26
    add  r19, r0
    adc  r24, r1
    adc  r25, r26
    mulsu r23, r20
    sbc  r25, r26
    add  r19, r0
    adc  r24, r1
    adc  r25, r26
    clr  r1
    ret
    .size multiplyTimes14, . - multiplyTimes14
