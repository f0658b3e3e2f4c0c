; SPDX-License-Identifier: GPL-3.0-or-later
; Without it the processor is busy 0.2 % more (docs/measurements.md).
; Between floats and whole numbers, rounded to the nearest, halves away from zero: core/convert.hpp
; says what each does. Floats come and go in r25..r22, least byte lowest.

    .section .text.libgcc.fixed_from_float, "ax", @progbits
    .global fixedFromFloat
    .type   fixedFromFloat, @function
fixedFromFloat:             ; times 2^r20, into r25 r24
    bst  r25, 7
    lsl  r24
    rol  r25
    add  r25, r20           ; the exponent
    brcs 6f
    cpi  r25, 127 + 15
    brsh 6f
    cpi  r25, 127 - 1
    brlo 5f
    sec
    ror  r24                ; with the leading one r24 r23 are the number times 2^(142 - exponent)
    ldi  r26, 127 + 15
    sub  r26, r25
    cpi  r26, 9
    brlo 1f
    mov  r23, r24
    clr  r24
    subi r26, 8
1:  lsr  r24
    ror  r23
    dec  r26
    brne 1b
    adc  r23, r1            ; what fell out last was the half
    adc  r24, r1
    brtc 2f
    com  r24
    neg  r23
    sbci r24, -1
    rjmp 3f
2:  sbrc r24, 7
    rjmp 6f
3:  mov  r25, r24
    mov  r24, r23
    ret
5:  clr  r24
    clr  r25
    ret
6:  ldi  r24, 0xFF
    ldi  r25, 0x7F
    brtc 7f
    com  r24
    com  r25
7:  ret
    .size fixedFromFloat, . - fixedFromFloat

    .section .text.libgcc.float_from_fixed, "ax", @progbits
    .global floatFromInt16
    .type   floatFromInt16, @function
floatFromInt16:             ; r25 r24
    ldi  r22, 0
    .size floatFromInt16, . - floatFromInt16
    .global floatFromFixed
    .type   floatFromFixed, @function
floatFromFixed:             ; r25 r24 times 2^-r22
    bst  r25, 7
    brtc 1f
    com  r25
    neg  r24
    sbci r25, -1
1:  ldi  r26, 127 + 15      ; the exponent
    sub  r26, r22
    clr  r22
    tst  r25
    brne 2f
    mov  r25, r24
    clr  r24
    subi r26, 8
    tst  r25
    breq 5f
2:  brmi 4f
3:  dec  r26
    lsl  r24
    rol  r25
    brpl 3b
4:  mov  r23, r24
    mov  r24, r25
    mov  r25, r26
    lsl  r24                ; the leading one is not kept
    lsr  r25
    ror  r24
    bld  r25, 7
    ret
5:  clr  r23
    ret
    .size floatFromFixed, . - floatFromFixed

    .section .text.libgcc.rounded_float, "ax", @progbits
    .global roundedFloat
    .type   roundedFloat, @function
roundedFloat:               ; into r25..r22
    mov  r26, r24
    mov  r27, r25
    lsl  r26
    rol  r27
    cpi  r27, 127 + 23
    brlo 1f
    jmp  __fixsfsi          ; whole
1:  cpi  r27, 127 - 1
    brlo 6f
    bst  r25, 7
    clr  r25
    ori  r24, 0x80
    ldi  r26, 127 + 23
    sub  r26, r27
2:  cpi  r26, 9
    brlo 3f
    mov  r22, r23
    mov  r23, r24
    clr  r24
    subi r26, 8
    rjmp 2b
3:  lsr  r24
    ror  r23
    ror  r22
    dec  r26
    brne 3b
    adc  r22, r1            ; what fell out last was the half
    adc  r23, r1
    adc  r24, r1
    brtc 4f
    com  r25
    com  r24
    com  r23
    neg  r22
    sbci r23, -1
    sbci r24, -1
    sbci r25, -1
4:  ret
6:  clr  r22
    clr  r23
    clr  r24
    clr  r25
    ret
    .size roundedFloat, . - roundedFloat

    .section .text.libgcc.scaled_floats, "ax", @progbits
    .global floatFromCentidegrees
    .type   floatFromCentidegrees, @function
floatFromCentidegrees:      ; r25 r24 times pi / 18000
    call floatFromInt16
    ldi  r21, 0x39
    ldi  r20, 0x37
    ldi  r19, 0x02
    ldi  r18, 0xD4
    jmp  __mulsf3
    .size floatFromCentidegrees, . - floatFromCentidegrees

    .global thousandthsOfInt16
    .type   thousandthsOfInt16, @function
thousandthsOfInt16:         ; r25 r24 times 0.001
    call floatFromInt16
    rjmp 1f
    .size thousandthsOfInt16, . - thousandthsOfInt16
    .global thousandthsOfInt32
    .type   thousandthsOfInt32, @function
thousandthsOfInt32:         ; r25..r22 times 0.001
    call __floatsisf
1:  ldi  r21, 0x3A
    ldi  r20, 0x83
    ldi  r19, 0x12
    ldi  r18, 0x6F
    jmp  __mulsf3
    .size thousandthsOfInt32, . - thousandthsOfInt32

    .global floatFromFixed30
    .type   floatFromFixed30, @function
floatFromFixed30:           ; r25..r22 times 2^-30
    call __floatsisf
    ldi  r21, 0x30
    ldi  r20, 0x80
    ldi  r19, 0
    ldi  r18, 0
    jmp  __mulsf3
    .size floatFromFixed30, . - floatFromFixed30

    .global floatFromAngle
    .type   floatFromAngle, @function
floatFromAngle:             ; r25 r24 times pi / 32768
    call floatFromInt16
    ldi  r21, 0x38
    ldi  r20, 0xC9
    ldi  r19, 0x0F
    ldi  r18, 0xDB
    jmp  __mulsf3
    .size floatFromAngle, . - floatFromAngle

    .global hundredthsOfInt32
    .type   hundredthsOfInt32, @function
hundredthsOfInt32:          ; r25..r22 times 0.01
    call __floatsisf
    rjmp 1f
    .size hundredthsOfInt32, . - hundredthsOfInt32
    .global hundredthsOfInt16
    .type   hundredthsOfInt16, @function
hundredthsOfInt16:          ; r25 r24 times 0.01
    call floatFromInt16
1:  ldi  r21, 0x3C
    ldi  r20, 0x23
    ldi  r19, 0xD7
    ldi  r18, 0x0A
    jmp  __mulsf3
    .size hundredthsOfInt16, . - hundredthsOfInt16
