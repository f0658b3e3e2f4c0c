; SPDX-License-Identifier: GPL-3.0-or-later
; Without it the processor is busy 0.4 % more (docs/measurements.md).
; The compiler's sum and difference of two floats, in two thirds of the library's cycles and with
; the same bits: rounded to the nearest, ties to even. What is not finite and normal, or would not
; be afterwards, is left to the library's own parts.
; In: r25..r22 and r21..r18, least byte lowest. Out: r25..r22.

    .section .text.libgcc.float_sum, "ax", @progbits
    .global __subsf3
    .type   __subsf3, @function
    .global __addsf3
    .type   __addsf3, @function
.Lexchange:
    neg  r31
    movw r0, r22
    movw r22, r18
    movw r18, r0
    movw r0, r24
    movw r24, r20
    movw r20, r0
    clr  r1
    rjmp .Llarger_first

.Llibrary:
    clr  r26
    clr  r27
    call __addsf3x
    jmp  __fp_round

.Lfar:
    or   r0, r30
    mov  r30, r18
    mov  r18, r19
    mov  r19, r20
    clr  r20
    subi r31, 8
    cpi  r31, 8
    brsh .Lfar
    tst  r31
    breq .Laligned
4:  lsr  r20
    ror  r19
    ror  r18
    ror  r30
    brcc 5f
    mov  r0, r25        ; anything but 0
5:  dec  r31
    brne 4b
    rjmp .Laligned

__subsf3:
    subi r21, 0x80
__addsf3:
    movw r30, r24
    lsl  r30
    rol  r31            ; the exponent
    movw r26, r20
    lsl  r26
    rol  r27
    mov  r30, r31
    subi r30, 26        ; 10^-30 and more, so that no difference but 0 is too small
    cpi  r30, 228       ; and the sum not too large
    brsh .Llibrary
    mov  r30, r27
    subi r30, 26
    cpi  r30, 228
    brsh .Llibrary
    sub  r31, r27
    brlo .Lexchange
.Llarger_first:
    cpi  r31, 26
    brsh 9f             ; less than half of the last place
    bst  r25, 7
    mov  r26, r21
    eor  r26, r25       ; do the signs differ?
    lsl  r24            ; makes room for the leading one, and brings the exponent together
    rol  r25
    sec
    ror  r24
    ori  r20, 0x80
    clr  r30            ; what falls out below, and in r0 whether there was more
    clr  r0
    cpi  r31, 8
    brsh .Lfar
    tst  r31
    breq .Laligned
1:  lsr  r20
    ror  r19
    ror  r18
    ror  r30
    dec  r31
    brne 1b
.Laligned:
    sbrc r26, 7
    rjmp .Ldifference
    add  r22, r18
    adc  r23, r19
    adc  r24, r20
    brcc .Lrounded
    ror  r24
    ror  r23
    ror  r22
    ror  r30
    brcc 3f
    mov  r0, r25
3:  inc  r25
.Lrounded:
    lsl  r24
    lsr  r25
    ror  r24
    bld  r25, 7
    lsl  r30
    brcc 9f
    or   r30, r0
    brne 8f
    sbrs r22, 0
    ret
8:  subi r22, -1
    sbci r23, -1
    sbci r24, -1
    sbci r25, -1
9:  ret

.Ldifference:
    neg  r30
    cpse r0, r1
    rjmp .Linexact
.Lborrowed:
    sbc  r22, r18
    sbc  r23, r19
    sbc  r24, r20
    brlo .Lnegative
    brmi .Lrounded
    mov  r26, r22
    or   r26, r23
    or   r26, r24
    or   r26, r30
    breq .Lzero
.Lshift:
    dec  r25
    lsl  r30
    rol  r22
    rol  r23
    rol  r24
    brpl .Lshift
    rjmp .Lrounded

.Linexact:
    dec  r30            ; there is more below
    sec
    rjmp .Lborrowed

.Lnegative:               ; of equal exponents, so nothing is below
    com  r24
    com  r23
    neg  r22
    sbci r23, -1
    sbci r24, -1
    bld  r26, 0
    com  r26
    bst  r26, 0
    tst  r24
    brmi .Lrounded
    rjmp .Lshift

.Lzero:
    clr  r25
    ret
    .size __addsf3, . - __addsf3
