// SPDX-License-Identifier: GPL-3.0-or-later
// The EEPROM and the queue before it, with the answers libraries/hal/eeprom.hpp promises.
#pragma once
#include <algorithm>
#include <cstdint>
#include <deque>
#include <vector>

#include "core/status.hpp"
#include "simulator/devices/random.hpp"
#include "simulator/devices/worn_cells.hpp"

namespace simulator {

class EepromChip {
public:
    explicit EepromChip(const uint64_t& now_us, uint64_t seed = 1);

    core::Status read(uint16_t address, void* to, uint8_t size);
    core::Status write(uint16_t address, const void* from, uint8_t size);
    bool drained() const { return queue_.empty(); }

    const std::vector<uint8_t>& cells() const { return cells_; }
    void setCells(const std::vector<uint8_t>& cells);

    // While the supply is too low, what is written becomes whatever chance will have.
    void endanger(bool endangered);
    void wear(const WornCells& worn) { worn_ = worn; }
    void restart();  // a write in flight goes on, those that wait are lost

    uint64_t due_us() const;
    void run();

private:
    struct Write {
        uint16_t address;
        uint8_t value;
    };
    uint8_t seen(uint16_t address) const;  // as if the queue had been written
    void begin();
    uint64_t beginsAt_us() const { return std::max(patience_until_us_, rest_until_us_); }
    bool writing() const { return written_us_ != UINT64_MAX; }

    const uint64_t& now_us_;
    std::vector<uint8_t> cells_;
    std::deque<Write> queue_;           // the front is the one in flight while writing()
    uint64_t written_us_ = UINT64_MAX;  // when the byte in flight is done
    unsigned writes_ = 0;               // of it, as long as it does not read back
    Random random_;
    WornCells worn_;
    bool endangered_ = false, spoilt_ = false;
    uint64_t patience_until_us_ = 0;  // a reader was refused and comes back
    uint16_t waiting_address_ = 0;    // of that reader
    uint64_t rest_until_us_ = 0;
};

}  // namespace simulator
