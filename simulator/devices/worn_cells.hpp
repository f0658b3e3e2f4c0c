// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of an EEPROM that are worn out: after more than the 100,000 writes of the data sheet (8.1)
// a bit of a byte stays what it is, whatever is written.
#pragma once
#include <cstdint>
#include <map>
#include <vector>

namespace simulator {

class WornCells {
public:
    WornCells() = default;
    // So many bytes of a memory of that size, each with one bit that stays 0 or 1.
    WornCells(unsigned cells, uint16_t memory_bytes, uint64_t seed);

    void stick(uint16_t address, uint8_t bits, bool high);
    uint8_t written(uint16_t address, uint8_t value) const;  // what the byte becomes

private:
    struct Stuck {
        uint8_t high = 0, low = 0;
    };
    std::map<uint16_t, Stuck> cells_;
};

// So many bits of a memory, anywhere, have changed by themselves.
void rot(std::vector<uint8_t>& memory, unsigned bits, uint64_t seed);

}  // namespace simulator
