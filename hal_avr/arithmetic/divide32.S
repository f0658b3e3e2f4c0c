; SPDX-License-Identifier: GPL-3.0-or-later
; Without it the processor is busy 0.2 % more (docs/measurements.md), and runRadio, which divides for
; each channel, takes 209 us at the longest instead of 167, past its 190.
; The compiler's quotient of two whole numbers without a sign, bit by bit as the library's, but not
; for the dividend's leading bytes of 0, and with two bytes of rest for a divisor of two.
; In: r25..r22 by r21..r18. Out: the quotient in r21..r18, the rest in r25..r22. T and r0 stay.

    .section .text.libgcc.quotient32, "ax", @progbits
    .global __udivmodsi4
    .type   __udivmodsi4, @function
__udivmodsi4:
    ldi  r26, 33
1:  tst  r25
    brne 2f
    mov  r25, r24
    mov  r24, r23
    mov  r23, r22
    ldi  r22, 0xFF          ; bits of 0 in the quotient, which is turned round below
    subi r26, 8
    cpi  r26, 9
    brne 1b
2:  mov  r1, r26            ; counts down to the 0 it is otherwise
    clr  r26
    clr  r27
    clr  r31
    mov  r30, r20
    or   r30, r21
    breq .Lshort
    clr  r30
    sec
    rjmp 5f
3:  rol  r26
    rol  r27
    rol  r30
    rol  r31
    cp   r26, r18
    cpc  r27, r19
    cpc  r30, r20
    cpc  r31, r21
    brcs 5f
    sub  r26, r18
    sbc  r27, r19
    sbc  r30, r20
    sbc  r31, r21
5:  rol  r22
    rol  r23
    rol  r24
    rol  r25
    dec  r1
    brne 3b
.Lturned:
    com  r22
    com  r23
    com  r24
    com  r25
    movw r18, r22
    movw r20, r24
    movw r22, r26
    movw r24, r30
    ret

.Lshort:
    sec
    rjmp 8f
6:  rol  r26
    rol  r27
    brcs 7f
    cp   r26, r18
    cpc  r27, r19
    brcs 8f
7:  sub  r26, r18
    sbc  r27, r19
    clc
8:  rol  r22
    rol  r23
    rol  r24
    rol  r25
    dec  r1
    brne 6b
    rjmp .Lturned
    .size __udivmodsi4, . - __udivmodsi4
