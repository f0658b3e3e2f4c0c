; SPDX-License-Identifier: GPL-3.0-or-later
; Without it the processor is busy 0.2 % more (docs/measurements.md).
; The compiler's comparisons of two floats, in two thirds of the library's cycles. What may not be
; a number is left to the library's own part.
; In: r25..r22 and r21..r18, least byte lowest. Out: r24: -1, 0 or 1, and for no number what makes
; the comparison false: 1 for "less", -1 for "greater", which T keeps apart.

    .section .text.libgcc.float_compare, "ax", @progbits
    .global __gesf2
    .type   __gesf2, @function
    .global __gtsf2
    .type   __gtsf2, @function
    .global __cmpsf2
    .type   __cmpsf2, @function
    .global __eqsf2
    .type   __eqsf2, @function
    .global __nesf2
    .type   __nesf2, @function
    .global __ltsf2
    .type   __ltsf2, @function
    .global __lesf2
    .type   __lesf2, @function
__gesf2:
__gtsf2:
    set
    rjmp 1f
__cmpsf2:
__eqsf2:
__nesf2:
__ltsf2:
__lesf2:
    clt
1:  mov  r30, r25
    lsl  r30
    cpi  r30, 0xFE      ; the exponent is 254 or 255
    brsh 8f
    mov  r30, r21
    lsl  r30
    cpi  r30, 0xFE
    brsh 8f
    mov  r30, r25
    eor  r30, r21
    brmi 4f
    cp   r22, r18
    cpc  r23, r19
    cpc  r24, r20
    cpc  r25, r21
    breq 6f
    sbc  r24, r24
    ori  r24, 1
    sbrc r25, 7
    neg  r24
    ret
4:  ; of opposite signs, but zeros are equal
    lsl  r25
    sbc  r30, r30       ; -1: the first is negative
    lsl  r21
    or   r25, r24
    or   r25, r23
    or   r25, r22
    or   r25, r21
    or   r25, r20
    or   r25, r19
    or   r25, r18
    breq 6f
    mov  r24, r30
    ori  r24, 1
    ret
6:  ldi  r24, 0
    ret
8:  call __fp_cmp
    brcc 9f
    ldi  r24, 1
    brtc 9f
    neg  r24
9:  ret
    .size __gesf2, . - __gesf2
