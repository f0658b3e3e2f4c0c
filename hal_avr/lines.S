; SPDX-License-Identifier: GPL-3.0-or-later
; Where serial.cpp's rings lie: the first bytes of the RAM, below .data (toolchain/avr_flags.cmake),
; so that both links' bytes begin at a multiple of 256.

    .section .lines, "aw", @nobits
    .global serialLines
    .type   serialLines, @object
serialLines:
    .skip 386
    .size serialLines, . - serialLines
