// SPDX-License-Identifier: GPL-3.0-or-later
#include "crypto/sha256.hpp"

#include <string.h>

#include "core/rom.hpp"
#include "crypto/rounds.hpp"

namespace crypto {
namespace {

// FIPS 180-4, 5.3.3: the fractions of the square roots of the first eight primes.
constexpr uint32_t kStart[8] ROM = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                    0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};

// FIPS 180-4, 4.2.2: the fractions of the cube roots of the first 64 primes.
constexpr uint32_t kConstants[64] ROM = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

constexpr uint8_t kRounds = 64;
constexpr uint8_t kRoundsAtOnce = 16;

// Words are big-endian in a message, little-endian here.
constexpr uint8_t swapped(uint8_t at) { return at ^ 3; }

}  // namespace

void Sha256::begin() {
    for (uint8_t i = 0; i < 8; ++i) hash_[i] = core::romRead(kStart[i]);
    memcpy(work_, hash_, sizeof work_);
    round_ = 0;
}

uint8_t& Sha256::byte(uint8_t at) { return reinterpret_cast<uint8_t*>(words_)[swapped(at)]; }

uint8_t Sha256::hash(uint8_t at) const {
    return reinterpret_cast<const uint8_t*>(hash_)[swapped(at)];
}

void Sha256::pad(uint8_t block, uint16_t size) {
    constexpr uint8_t kEnd = 0x80;
    for (uint8_t i = 0; i < kBlockSize; ++i) {
        const uint16_t at = static_cast<uint16_t>(block * kBlockSize + i);
        if (at >= size) byte(i) = at == size ? kEnd : 0;
    }
    if (block + 1 < blocksOf(size)) return;
    const uint16_t bits = static_cast<uint16_t>(size * 8);
    byte(kBlockSize - 2) = static_cast<uint8_t>(bits >> 8);
    byte(kBlockSize - 1) = static_cast<uint8_t>(bits);
}

bool Sha256::quarter() {
    if (round_ > 0) expandWords(words_);
    uint32_t window[kRoundsAtOnce + 8];
    memcpy(window + kRoundsAtOnce, work_, sizeof work_);
    doRounds(window + kRoundsAtOnce, words_, kConstants + round_);
    memcpy(work_, window, sizeof work_);
    round_ = static_cast<uint8_t>(round_ + kRoundsAtOnce);
    if (round_ < kRounds) return false;
    for (uint8_t i = 0; i < 8; ++i) work_[i] = hash_[i] += work_[i];
    round_ = 0;
    return true;
}

}  // namespace crypto
