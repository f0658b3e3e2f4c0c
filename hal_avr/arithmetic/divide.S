; SPDX-License-Identifier: GPL-3.0-or-later
; Without it the processor is busy 0.7 % more (docs/measurements.md).
; The compiler's quotient of two floats, in less than half of the library's cycles and with the
; same bits: rounded to the nearest; a quotient never lies in the middle. It is worked out by bytes:
; each is guessed from the upper byte of the divisor, at most a few too small, and then made right.
; What is not finite and normal, or would not be afterwards, is left to the library's own parts.
; In: r25..r22 by r21..r18, least byte lowest. Out: r25..r22.

    .section .progmem.data.reciprocals, "a", @progbits
.Lreciprocals:              ; rounded down, of the divisor's upper byte 128..255 and the rest
    .set upper, 129
    .rept 128
    .byte 32768 / upper
    .set upper, upper + 1
    .endr

    .section .text.libgcc.float_quotient, "ax", @progbits
    .global __divsf3
    .type   __divsf3, @function

; What remains in a b c, times 256, by the divisor in r20..r18: the quotient q, a byte, and what
; remains then in b c d. In r26 is the reciprocal, which q may replace; r27 is 0.
.macro next_byte a, b, c, d, q
    mul  \b, r26
    mov  \d, r1
    mul  \a, r26
    add  r0, \d
    adc  r1, r27
    lsl  r0
    rol  r1
    mov  \q, r1
    mov  \d, r27
    mul  \q, r18
    sub  \d, r0
    sbc  \c, r1
    sbc  \b, r27
    sbc  \a, r27
    mul  \q, r19
    sub  \c, r0
    sbc  \b, r1
    sbc  \a, r27
    mul  \q, r20
    sub  \b, r0
    sbc  \a, r1
1:  sub  \d, r18
    sbc  \c, r19
    sbc  \b, r20
    sbc  \a, r27
    inc  \q
    brcc 1b
    dec  \q
    add  \d, r18
    adc  \c, r19
    adc  \b, r20
.endm

.Lnegative:
    cpi  r31, 131
    brsh .Lfinite
.Llibrary:
    call __divsf3x
    jmp  __fp_round

__divsf3:
    movw r30, r24
    lsl  r30
    rol  r31            ; the exponent
    movw r26, r20
    lsl  r26
    rol  r27
    mov  r26, r31
    dec  r26
    cpi  r26, 254
    brsh .Llibrary        ; 0 and 255
    mov  r26, r27
    dec  r26
    cpi  r26, 254
    brsh .Llibrary
    sub  r31, r27
    brcs .Lnegative
    cpi  r31, 127
    brsh .Llibrary        ; too large
.Lfinite:
    subi r31, -127
    mov  r0, r25
    eor  r0, r21
    bst  r0, 7
    mov  r25, r31
    ori  r24, 0x80
    ori  r20, 0x80
    clr  r27
    mov  r30, r20
    ldi  r31, 0
    subi r30, lo8(-(.Lreciprocals - 128))
    sbci r31, hi8(-(.Lreciprocals - 128))
    lpm  r26, Z
    cp   r22, r18
    cpc  r23, r19
    cpc  r24, r20
    brsh 2f
    dec  r25
    lsl  r22
    rol  r23
    rol  r24
2:  sub  r22, r18       ; the leading one
    sbc  r23, r19
    sbc  r24, r20
    next_byte r24, r23, r22, r21, r31
    next_byte r23, r22, r21, r24, r30
    next_byte r22, r21, r24, r23, r26
    mov  r1, r27
    mov  r24, r31
    mov  r23, r30
    mov  r22, r26
    lsr  r25            ; the leading one is not kept
    ror  r24
    ror  r23
    ror  r22
    bld  r25, 7
    adc  r22, r1
    adc  r23, r1
    adc  r24, r1
    adc  r25, r1
    ret
    .size __divsf3, . - __divsf3
