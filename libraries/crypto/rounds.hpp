// SPDX-License-Identifier: GPL-3.0-or-later
// The inner loops of SHA-256 (FIPS 180-4, 6.2.2), 16 rounds at once. Between the files of this
// folder only.
#pragma once
#include <stdint.h>

#include "core/rom.hpp"

#ifdef __AVR__
extern "C" {  // hal_avr
void sha256Expand(uint32_t* words);
void sha256Rounds(uint32_t* a, const uint32_t* words, const uint32_t* constants);
}
#endif

namespace crypto {

#ifdef __AVR__
inline void expandWords(uint32_t* words) { sha256Expand(words); }
inline void doRounds(uint32_t* a, const uint32_t* words, const uint32_t* constants) {
    sha256Rounds(a, words, constants);
}
#else
inline uint32_t right(uint32_t word, uint8_t by) { return word >> by | word << (32 - by); }

// The next 16 words of the message schedule, over the last 16.
inline void expandWords(uint32_t* words) {
    for (uint8_t i = 0; i < 16; ++i) {
        const uint32_t x = words[(i + 14) % 16], y = words[(i + 1) % 16];
        words[i] += words[(i + 9) % 16] + (right(x, 17) ^ right(x, 19) ^ x >> 10) +
                    (right(y, 7) ^ right(y, 18) ^ y >> 3);
    }
}

// `a` is the first of a to h; each round puts the new a before it, so that the eight stand 16 words
// earlier in the end. The constants are in flash.
inline void doRounds(uint32_t* a, const uint32_t* words, const uint32_t* constants) {
    for (uint8_t i = 0; i < 16; ++i, --a) {
        const uint32_t e = a[4];
        const uint32_t sum = a[7] + core::romRead(constants[i]) + words[i] +
                             (right(e, 6) ^ right(e, 11) ^ right(e, 25)) +
                             (a[6] ^ (e & (a[5] ^ a[6])));
        a[3] += sum;
        a[-1] = sum + (right(a[0], 2) ^ right(a[0], 13) ^ right(a[0], 22)) +
                (a[1] ^ ((a[0] ^ a[1]) & (a[1] ^ a[2])));
    }
}
#endif

}  // namespace crypto
