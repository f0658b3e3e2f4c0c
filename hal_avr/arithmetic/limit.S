; SPDX-License-Identifier: GPL-3.0-or-later
; Without it the processor is busy 0.3 % more (docs/measurements.md).
; core::limit of floats, in their order by bits, core::orderOf's: that of their sizes, turned round
; below 0. In: r25..r22, the lowest in r21..r18, the highest in r17..r14. Out: r25..r22.

    .section .text.libgcc.limit_float, "ax", @progbits
    .global limitFloat
    .type   limitFloat, @function
limitFloat:
    sbrc r25, 7
    rjmp 2f
    sbrc r21, 7
    rjmp 1f
    cp   r22, r18
    cpc  r23, r19
    cpc  r24, r20
    cpc  r25, r21
    brlo 5f
1:  sbrc r17, 7
    rjmp 4f
    cp   r14, r22
    cpc  r15, r23
    cpc  r16, r24
    cpc  r17, r25
    brlo 4f
    ret
2:  sbrs r21, 7
    rjmp 5f
    cp   r18, r22
    cpc  r19, r23
    cpc  r20, r24
    cpc  r21, r25
    brlo 5f
    sbrs r17, 7
    ret
    cp   r22, r14
    cpc  r23, r15
    cpc  r24, r16
    cpc  r25, r17
    brlo 4f
    ret
4:  movw r22, r14
    movw r24, r16
    ret
5:  movw r22, r18
    movw r24, r20
    ret
    .size limitFloat, . - limitFloat

; The same between 0 and 1, of which the caller then need not bring either.
    .section .text.libgcc.limit_share, "ax", @progbits
    .global limitShare
    .type   limitShare, @function
limitShare:
    tst  r25
    brmi 1f
    ldi  r18, 0x3F      ; 1.0 begins with 0x3F80
    cpi  r24, 0x80
    cpc  r25, r18
    brlo 3f
    mov  r25, r18
    ldi  r24, 0x80
    rjmp 2f
1:  clr  r25
    clr  r24
2:  clr  r23
    clr  r22
3:  ret
    .size limitShare, . - limitShare
