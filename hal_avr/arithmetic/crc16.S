; SPDX-License-Identifier: GPL-3.0-or-later
; core::crc16 of many bytes: three products make the shifts for a byte, which takes 19 cycles.
; In: the checksum in r25 r24, where the bytes are in r23 r22, how many in r21 r20. Out: r25 r24.

    .section .text.libgcc.crc16, "ax", @progbits
    .global crc16OfBytes
    .type   crc16OfBytes, @function
crc16OfBytes:
    movw r26, r22
    ldi  r30, 1 << 4
    ldi  r31, 1 << 3
    subi r20, 0
    sbci r21, 0
    breq 2f
1:  ld   r18, X+
    eor  r18, r24
    mul  r18, r30
    eor  r18, r0
    mul  r18, r30
    eor  r25, r1
    mul  r18, r31
    eor  r25, r0
    mov  r24, r25
    eor  r18, r1
    mov  r25, r18
    subi r20, 1
    sbci r21, 0
    brne 1b
    clr  r1
2:  ret
    .size crc16OfBytes, . - crc16OfBytes
