// SPDX-License-Identifier: GPL-3.0-or-later
// What all parameter slots hold, as four bytes that change with each of them. A single changed bit
// is found by it and can be undone; two are noticed, and most of more.
#pragma once
#include <stdint.h>

#include "storage/eeprom_map.hpp"

namespace storage {

struct ParameterCheck {
    // The numbers of all bits that are set, XORed: a changed bit adds or takes its own. Bit 15 is
    // in all of them, so that it is the parity.
    uint16_t bits;
    uint16_t crc;  // of each slot's value, begun with its number, XORed

    // Takes a slot's value in, or out again.
    void toggle(uint8_t slot, uint32_t value);
    // The slot and the bit of it that is wrong, if it is one, where this should be `wanted`.
    bool locate(const ParameterCheck& wanted, uint8_t& slot, uint32_t& bit) const;
};
inline bool operator==(const ParameterCheck& a, const ParameterCheck& b) {
    return a.bits == b.bits && a.crc == b.crc;
}

// As it lies in the EEPROM. Blank, all ones, is none: no slots have these bits.
void putCheck(const ParameterCheck& check, uint8_t (&to)[kCheckSize]);
ParameterCheck getCheck(const uint8_t* from);
constexpr ParameterCheck kNoCheck = {0xFFFF, 0xFFFF};

}  // namespace storage
