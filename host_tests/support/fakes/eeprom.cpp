// SPDX-License-Identifier: GPL-3.0-or-later
#include "fakes/eeprom.hpp"

#include <string.h>

#include <algorithm>
#include <array>
#include <deque>

#include "fakes/clock.hpp"
#include "hal/eeprom.hpp"

namespace {

constexpr uint64_t kByte_us = 3400;
constexpr uint64_t kReaderPatience_us = 131000;

struct Entry {
    uint16_t address;
    uint8_t value;
};

struct Chip {
    std::array<uint8_t, hal::kEepromSize> cells, seen;  // seen: with all that was queued
    std::array<uint8_t, hal::kEepromSize> stuck_high, stuck_low;
    std::deque<Entry> queue;
    bool slow, in_flight, reader_waits;
    uint64_t done_us, reader_since_us;
    uint32_t writes;

    Chip() { erase(); }

    void erase() {
        cells.fill(0xFF);
        stuck_high.fill(0);
        stuck_low.fill(0);
        writes = 0;
        slow = false;
        restart();
    }

    void restart() {
        seen = cells;
        queue.clear();
        in_flight = reader_waits = false;
        fakes::restorePower();
    }

    void put(uint16_t address, uint8_t value) {
        cells[address] = static_cast<uint8_t>((value | stuck_high[address]) & ~stuck_low[address]);
    }

    // Writes one cell, or loses it with the power.
    void program(const Entry& entry) {
        const fakes::Fate fate = fakes::beginWrite();
        if (fate == fakes::Fate::lost) return;
        ++writes;
        const uint8_t torn =
            fakes::tearsWrites() ? static_cast<uint8_t>(fakes::tornNoise()) : uint8_t{0xFF};
        put(entry.address, fate == fakes::Fate::done ? entry.value : torn);
        const bool worn = (stuck_high[entry.address] | stuck_low[entry.address]) != 0;
        if (worn && seen[entry.address] == entry.value) seen[entry.address] = cells[entry.address];
    }

    // The interrupt's part: begins the next byte that differs.
    void begin(uint64_t at_us) {
        while (!queue.empty() && cells[queue.front().address] == queue.front().value) {
            queue.pop_front();
        }
        in_flight = !queue.empty();
        done_us = at_us + kByte_us;
    }

    void catchUp() {
        const uint64_t now_us = fakes::time_us();
        while (slow && !queue.empty()) {
            if (in_flight && done_us > now_us) return;
            if (in_flight) {
                program(queue.front());
                queue.pop_front();
                in_flight = false;
            }
            uint64_t next_us = done_us;
            if (reader_waits) {
                next_us = reader_since_us + kReaderPatience_us;
                if (next_us > now_us) return;
                reader_waits = false;
            }
            begin(std::max(next_us, done_us));
        }
    }
};

Chip chip;

bool outside(uint16_t address, uint8_t size) {
    return address > hal::kEepromSize || size > hal::kEepromSize - address;
}

}  // namespace

namespace fakes {

void resetEeprom() { chip.erase(); }
std::vector<uint8_t> eepromCells() { return {chip.cells.begin(), chip.cells.end()}; }

void setEepromCells(const std::vector<uint8_t>& cells) {
    for (size_t i = 0; i < std::min(cells.size(), chip.cells.size()); ++i)
        chip.put(static_cast<uint16_t>(i), cells[i]);
    chip.restart();
}

void setEepromCell(uint16_t address, uint8_t value) {
    chip.cells.at(address) = chip.seen.at(address) = value;
}

uint8_t eepromCell(uint16_t address) {
    chip.catchUp();
    return chip.cells.at(address);
}

void wearEepromCell(uint16_t address, uint8_t bits, bool high) {
    uint8_t& stuck = high ? chip.stuck_high.at(address) : chip.stuck_low.at(address);
    stuck = static_cast<uint8_t>(stuck | bits);
    chip.put(address, chip.cells[address]);
    chip.seen[address] = chip.cells[address];
}

void setEepromSlow(bool slow) { chip.slow = slow; }
void restartEeprom() {
    chip.catchUp();
    chip.restart();
}

uint32_t eepromWrites() {
    chip.catchUp();
    return chip.writes;
}

}  // namespace fakes

namespace hal {

core::Status eepromRead(uint16_t address, void* to, uint8_t size) {
    if (outside(address, size)) return core::Status::bad_argument;
    chip.catchUp();
    if (chip.in_flight) {
        if (!chip.reader_waits) chip.reader_since_us = fakes::time_us();
        chip.reader_waits = true;
        return core::Status::busy;
    }
    memcpy(to, &chip.seen[address], size);
    if (chip.reader_waits) {
        chip.reader_waits = false;
        if (!chip.queue.empty()) chip.begin(fakes::time_us());
    }
    return core::Status::ok;
}

core::Status eepromWrite(uint16_t address, const void* from, uint8_t size) {
    if (outside(address, size) || size > kEepromQueue) return core::Status::bad_argument;
    chip.catchUp();
    if (chip.slow && chip.queue.size() + size > kEepromQueue) return core::Status::busy;
    const uint8_t* bytes = static_cast<const uint8_t*>(from);
    for (uint8_t i = 0; i < size; ++i) {
        const Entry entry = {static_cast<uint16_t>(address + i), bytes[i]};
        const bool differs = chip.seen[entry.address] != entry.value;
        chip.seen[entry.address] = entry.value;
        if (chip.slow) {
            chip.queue.push_back(entry);
        } else if (differs) {
            chip.program(entry);
        }
    }
    if (!chip.queue.empty() && !chip.in_flight && !chip.reader_waits) {
        chip.begin(fakes::time_us());
    }
    return core::Status::ok;
}

bool eepromDrained() {
    chip.catchUp();
    return chip.queue.empty();
}

}  // namespace hal
