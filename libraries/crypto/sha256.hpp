// SPDX-License-Identifier: GPL-3.0-or-later
// SHA-256 (FIPS 180-4) of short messages, in slices: a block takes this chip more time than a frame
// can spare, so each call does a quarter of one. 130 bytes of RAM.
#pragma once
#include <stdint.h>

namespace crypto {

constexpr uint8_t kBlockSize = 64;
constexpr uint8_t kQuarters = 4;  // calls of Sha256::quarter for a block

class Sha256 {
public:
    void begin();

    // A block at a time: its bytes are written to byte(0) .. byte(63), whatever was there before,
    // then quarter() is called until it answers true. Padding is the caller's: pad().
    uint8_t& byte(uint8_t at);
    // The end of a message of so many bytes: what stands behind its last byte in block `block`, and
    // in the last one its length.
    void pad(uint8_t block, uint16_t size);
    bool quarter();  // 16 rounds; true: the block is in the hash

    uint8_t hash(uint8_t at) const;  // byte 0 to 31 of it, after the last block

private:
    uint32_t hash_[8];
    uint32_t work_[8];    // a .. h
    uint32_t words_[16];  // the last of the message schedule
    uint8_t round_;
};

// Blocks that a message of so many bytes takes, padding included.
constexpr uint8_t blocksOf(uint16_t size) {
    return static_cast<uint8_t>((size + 1 + 8 + kBlockSize - 1) / kBlockSize);
}

}  // namespace crypto
