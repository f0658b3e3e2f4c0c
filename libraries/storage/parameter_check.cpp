// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/parameter_check.hpp"

#include "core/crc.hpp"
#include "storage/bytes.hpp"

namespace storage {
namespace {

constexpr uint16_t kParity = 0x8000;
constexpr uint8_t kBits = 8 * kParameterSize;
constexpr uint16_t kAllBits = kParameterSlots * kBits;
static_assert(kAllBits < 0x4000, "bits 14 and 15 of no check are both set with 13 others");

// Counted from 1: no bit's number is 0.
uint16_t numberOf(uint8_t slot, uint8_t bit) {
    return static_cast<uint16_t>((slot * kBits + bit + 1) | kParity);
}

}  // namespace

void ParameterCheck::toggle(uint8_t slot, uint32_t value) {
    uint8_t bytes[kParameterSize];
    put32(bytes, value);
    crc ^= core::crc16(slot, bytes, sizeof bytes);
    uint16_t number = numberOf(slot, 0);
    for (uint8_t byte : bytes)
        for (uint8_t left = 8; left > 0; --left, ++number, byte >>= 1)
            if ((byte & 1) != 0) bits ^= number;
}

bool ParameterCheck::locate(const ParameterCheck& wanted, uint8_t& slot, uint32_t& bit) const {
    const uint16_t number = bits ^ wanted.bits;
    const uint16_t place = static_cast<uint16_t>((number & ~kParity) - 1);
    if ((number & kParity) == 0 || place >= kAllBits) return false;
    slot = static_cast<uint8_t>(place / kBits);
    bit = uint32_t{1} << (place % kBits);
    return true;
}

void putCheck(const ParameterCheck& check, uint8_t (&to)[kCheckSize]) {
    put16(to, check.bits);
    put16(to + 2, check.crc);
}

ParameterCheck getCheck(const uint8_t* from) { return {get16(from), get16(from + 2)}; }

}  // namespace storage
