// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/worn_cells.hpp"

#include "simulator/devices/random.hpp"

namespace simulator {

WornCells::WornCells(unsigned cells, uint16_t memory_bytes, uint64_t seed) {
    Random random(seed, 19);
    while (cells_.size() < cells && cells_.size() < memory_bytes) {
        const auto address = static_cast<uint16_t>(random.bits() % memory_bytes);
        if (cells_.count(address) != 0) continue;
        stick(address, static_cast<uint8_t>(1 << random.bits() % 8), random.bits() & 1);
    }
}

void WornCells::stick(uint16_t address, uint8_t bits, bool high) {
    Stuck& cell = cells_[address];
    (high ? cell.high : cell.low) |= bits;
}

uint8_t WornCells::written(uint16_t address, uint8_t value) const {
    const auto cell = cells_.find(address);
    if (cell == cells_.end()) return value;
    return static_cast<uint8_t>((value | cell->second.high) & ~cell->second.low);
}

void rot(std::vector<uint8_t>& memory, unsigned bits, uint64_t seed) {
    Random random(seed, 20);
    for (unsigned i = 0; i < bits && !memory.empty(); ++i)
        memory[random.bits() % memory.size()] ^= static_cast<uint8_t>(1 << random.bits() % 8);
}

}  // namespace simulator
