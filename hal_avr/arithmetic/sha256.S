; SPDX-License-Identifier: GPL-3.0-or-later
; The inner loops of SHA-256 (FIPS 180-4, 6.2.2); what they stand for is written out in
; libraries/crypto/rounds.hpp. 26,000 cycles a block; compiled from that header it is 175,000, as the
; compiler makes loops of a word's turns. A word is turned here by whole bytes, which are only taken
; from another register, and at most three times by one bit.

#define BY0 r22                      /* the word that is turned */
#define BY1 r23
#define BY2 r24
#define BY3 r25

.macro LEFT_1
    lsl  BY0
    rol  BY1
    rol  BY2
    rol  BY3
    adc  BY0, r1
.endm

.macro RIGHT_1
    bst  BY0, 0
    lsr  BY3
    ror  BY2
    ror  BY1
    ror  BY0
    bld  BY3, 7
.endm

; Four times the same, of the bytes of two words, the least first.
.macro EACH what, a0, a1, a2, a3, b0, b1, b2, b3
    \what \a0, \b0
    \what \a1, \b1
    \what \a2, \b2
    \what \a3, \b3
.endm

.macro ADD_WORD a0, a1, a2, a3, b0, b1, b2, b3
    add  \a0, \b0
    adc  \a1, \b1
    adc  \a2, \b2
    adc  \a3, \b3
.endm

    .section .text.libgcc.sha256, "ax", @progbits

; void sha256Rounds(uint32_t* a, const uint32_t* words, const uint32_t* constants): 16 rounds. `a` is
; the first of a to h; each round puts the new a before it, so that the eight stand 16 words earlier
; in the end. The constants are in flash.
;   t: r18 to r21, sigma: r14 to r17, e and then a: r2 to r5
    .global sha256Rounds
    .type   sha256Rounds, @function
sha256Rounds:
    push r2
    push r3
    push r4
    push r5
    push r6
    push r14
    push r15
    push r16
    push r17
    push r28
    push r29
    movw r28, r24
    movw r26, r22
    movw r30, r20
    ldi  r18, 16
    mov  r6, r18
1:  ldd  r18, Y+28                   ; t = h + constant + word
    ldd  r19, Y+29
    ldd  r20, Y+30
    ldd  r21, Y+31
    lpm  r0, Z+
    add  r18, r0
    lpm  r0, Z+
    adc  r19, r0
    lpm  r0, Z+
    adc  r20, r0
    lpm  r0, Z+
    adc  r21, r0
    ld   r0, X+
    add  r18, r0
    ld   r0, X+
    adc  r19, r0
    ld   r0, X+
    adc  r20, r0
    ld   r0, X+
    adc  r21, r0

    ldd  r2, Y+16                    ; t += e turned right by 6, 11 and 25
    ldd  r3, Y+17
    ldd  r4, Y+18
    ldd  r5, Y+19
    movw BY0, r2
    movw BY2, r4
    RIGHT_1
    EACH mov, r14, r15, r16, r17, BY3, BY0, BY1, BY2
    RIGHT_1
    RIGHT_1
    EACH eor, r14, r15, r16, r17, BY1, BY2, BY3, BY0
    movw BY0, r2
    movw BY2, r4
    LEFT_1
    LEFT_1
    EACH eor, r14, r15, r16, r17, BY1, BY2, BY3, BY0
    ADD_WORD r18, r19, r20, r21, r14, r15, r16, r17

.macro CHOOSE add, t, e, f, g        ; t += e ? f : g
    ldd  r0, Y+\g
    ldd  BY0, Y+\f
    eor  BY0, r0
    and  BY0, \e
    eor  BY0, r0
    \add \t, BY0
.endm
    CHOOSE add, r18, r2, 20, 24
    CHOOSE adc, r19, r3, 21, 25
    CHOOSE adc, r20, r4, 22, 26
    CHOOSE adc, r21, r5, 23, 27

    ldd  r0, Y+12                    ; d += t
    add  r0, r18
    std  Y+12, r0
    ldd  r0, Y+13
    adc  r0, r19
    std  Y+13, r0
    ldd  r0, Y+14
    adc  r0, r20
    std  Y+14, r0
    ldd  r0, Y+15
    adc  r0, r21
    std  Y+15, r0

    ldd  r2, Y+0                     ; t += a turned right by 2, 13 and 22
    ldd  r3, Y+1
    ldd  r4, Y+2
    ldd  r5, Y+3
    movw BY0, r2
    movw BY2, r4
    LEFT_1
    LEFT_1
    EACH mov, r14, r15, r16, r17, BY3, BY0, BY1, BY2
    LEFT_1
    EACH eor, r14, r15, r16, r17, BY2, BY3, BY0, BY1
    movw BY0, r2
    movw BY2, r4
    RIGHT_1
    RIGHT_1
    EACH eor, r14, r15, r16, r17, BY0, BY1, BY2, BY3
    ADD_WORD r18, r19, r20, r21, r14, r15, r16, r17

.macro MAJORITY add, t, a, b, c      ; where a and b differ it is c
    ldd  BY0, Y+\b
    ldd  r0, Y+\c
    eor  r0, BY0
    eor  \a, BY0
    and  r0, \a
    eor  r0, BY0
    \add \t, r0
.endm
    MAJORITY add, r18, r2, 4, 8
    MAJORITY adc, r19, r3, 5, 9
    MAJORITY adc, r20, r4, 6, 10
    MAJORITY adc, r21, r5, 7, 11

    sbiw r28, 4
    std  Y+0, r18
    std  Y+1, r19
    std  Y+2, r20
    std  Y+3, r21
    dec  r6
    breq 2f
    rjmp 1b
2:  pop  r29
    pop  r28
    pop  r17
    pop  r16
    pop  r15
    pop  r14
    pop  r6
    pop  r5
    pop  r4
    pop  r3
    pop  r2
    ret
    .size sha256Rounds, . - sha256Rounds

; void sha256Expand(uint32_t* words): the next 16 words of the message schedule, over the last 16.
;   the words: r31 r30, the one in hand: r8 (bytes), its sum: r4 to r7, a sigma: r18 to r21
.macro POINT_AT words_ahead
    mov  r26, r8
    subi r26, -4 * \words_ahead
    andi r26, 63
    mov  r27, r31
    add  r26, r30
    adc  r27, r1
.endm

.macro LOAD a0, a1, a2, a3
    ld   \a0, X+
    ld   \a1, X+
    ld   \a2, X+
    ld   \a3, X+
.endm

    .global sha256Expand
    .type   sha256Expand, @function
sha256Expand:
    push r4
    push r5
    push r6
    push r7
    push r8
    push r14
    push r15
    push r16
    push r17
    movw r30, r24
    clr  r8
1:  POINT_AT 9
    LOAD r4, r5, r6, r7

    POINT_AT 1                       ; turned right by 7 and 18, shifted right by 3
    LOAD BY0, BY1, BY2, BY3
    movw r14, BY0
    movw r16, BY2
    RIGHT_1
    RIGHT_1
    movw r18, BY2
    movw r20, BY0
    RIGHT_1
    andi BY3, 0x1F
    EACH eor, r18, r19, r20, r21, BY0, BY1, BY2, BY3
    movw BY0, r14
    movw BY2, r16
    LEFT_1
    EACH eor, r18, r19, r20, r21, BY1, BY2, BY3, BY0
    ADD_WORD r4, r5, r6, r7, r18, r19, r20, r21

    POINT_AT 14                      ; turned right by 17 and 19, shifted right by 10
    LOAD BY0, BY1, BY2, BY3
    RIGHT_1
    movw r18, BY2
    movw r20, BY0
    RIGHT_1
    mov  r0, BY3
    andi BY3, 0x3F
    eor  r18, BY1
    eor  r19, BY2
    eor  r20, BY3
    mov  BY3, r0
    RIGHT_1
    EACH eor, r18, r19, r20, r21, BY2, BY3, BY0, BY1
    ADD_WORD r4, r5, r6, r7, r18, r19, r20, r21

    POINT_AT 0
    LOAD BY0, BY1, BY2, BY3
    ADD_WORD r4, r5, r6, r7, BY0, BY1, BY2, BY3
    st   -X, r7
    st   -X, r6
    st   -X, r5
    st   -X, r4
    ldi  r26, 4
    add  r8, r26
    sbrs r8, 6
    rjmp 1b
    pop  r17
    pop  r16
    pop  r15
    pop  r14
    pop  r8
    pop  r7
    pop  r6
    pop  r5
    pop  r4
    ret
    .size sha256Expand, . - sha256Expand
