; SPDX-License-Identifier: GPL-3.0-or-later
; Without it the processor is busy 1.2 % more (docs/measurements.md).
; The compiler's product of two floats, in two thirds of the library's cycles and with the same
; bits: rounded to the nearest, ties to even. What is 0 or very small or large is left to the
; library's own parts.
; In: r25..r22 and r21..r18, least byte lowest. Out: r25..r22.

    .section .text.libgcc.float_product, "ax", @progbits
    .global __mulsf3
    .type   __mulsf3, @function
.Llibrary:
    call __mulsf3x
    jmp  __fp_round

__mulsf3:
    movw r30, r24
    lsl  r30
    rol  r31            ; the exponent
    movw r26, r20
    lsl  r26
    rol  r27
    subi r31, 64        ; 10^-19 to 10^19, so that no product leaves the normal numbers
    cpi  r31, 127
    brsh .Llibrary
    subi r27, 64
    cpi  r27, 127
    brsh .Llibrary
    add  r31, r27
    inc  r31
    mov  r0, r25
    eor  r0, r21
    bst  r0, 7
    mov  r25, r31
    ldi  r21, 0
    ori  r24, 0x80
    ori  r20, 0x80
    ; into r23 r22 r31 r30 r27 r26
    mul  r22, r18
    movw r26, r0
    mul  r22, r20
    movw r30, r0
    mul  r22, r19
    add  r27, r0
    adc  r30, r1
    adc  r31, r21
    ldi  r22, 0
    mul  r23, r20
    add  r31, r0
    adc  r22, r1
    mul  r23, r18
    add  r27, r0
    adc  r30, r1
    adc  r31, r21
    adc  r22, r21
    mul  r23, r19
    add  r30, r0
    adc  r31, r1
    adc  r22, r21
    ldi  r23, 0
    mul  r24, r20
    add  r22, r0
    adc  r23, r1
    mul  r24, r18
    add  r30, r0
    adc  r31, r1
    adc  r22, r21
    adc  r23, r21
    mul  r24, r19
    add  r31, r0
    adc  r22, r1
    adc  r23, r21
    eor  r1, r1
    tst  r23
    brpl .Lbelow_two
    inc  r25
.Lnormal:
    or   r26, r27
    mov  r24, r23
    mov  r23, r22
    mov  r22, r31
    lsl  r24            ; the leading one is not kept
    lsr  r25
    ror  r24
    bld  r25, 7
    lsl  r30
    brcc 2f
    or   r30, r26
    brne 1f
    sbrs r22, 0
    ret
1:  subi r22, -1
    sbci r23, -1
    sbci r24, -1
    sbci r25, -1
2:  ret

.Lbelow_two:
    lsl  r27
    rol  r30
    rol  r31
    rol  r22
    rol  r23
    rjmp .Lnormal
    .size __mulsf3, . - __mulsf3
