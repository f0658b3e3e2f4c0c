// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/native/eeprom_chip.hpp"

#include <algorithm>

#include "hal/eeprom.hpp"

namespace simulator {

constexpr uint64_t kByte_us = 3400;  // ATmega2560 datasheet, table 8-2: 3.4 ms
constexpr uint64_t kPatience_us = 131'000;
constexpr uint64_t kRest_us = 29'400;  // of the driver, behind a byte that was written again

EepromChip::EepromChip(const uint64_t& now_us, uint64_t seed)
    : now_us_(now_us), cells_(hal::kEepromSize, 0xFF), random_(seed, 16) {}

void EepromChip::endanger(bool endangered) {
    endangered_ = endangered;
    if (writing() && endangered) spoilt_ = true;
}

void EepromChip::setCells(const std::vector<uint8_t>& cells) {
    std::copy_n(cells.begin(), std::min(cells.size(), cells_.size()), cells_.begin());
}

uint8_t EepromChip::seen(uint16_t address) const {
    for (auto write = queue_.rbegin(); write != queue_.rend(); ++write) {
        if (write->address == address) return write->value;
    }
    return cells_[address];
}

core::Status EepromChip::read(uint16_t address, void* to, uint8_t size) {
    if (address + size > hal::kEepromSize) return core::Status::bad_argument;
    if (writing()) {
        if (now_us_ >= patience_until_us_) {
            waiting_address_ = address;
            patience_until_us_ = now_us_ + kPatience_us;
        }
        return core::Status::busy;
    }
    for (uint8_t i = 0; i < size; ++i) static_cast<uint8_t*>(to)[i] = seen(address + i);
    if (address == waiting_address_) patience_until_us_ = 0;
    begin();
    return core::Status::ok;
}

core::Status EepromChip::write(uint16_t address, const void* from, uint8_t size) {
    if (address + size > hal::kEepromSize || size > hal::kEepromQueue) {
        return core::Status::bad_argument;
    }
    if (queue_.size() + size > hal::kEepromQueue) return core::Status::busy;
    for (uint8_t i = 0; i < size; ++i) {
        const uint8_t value = static_cast<const uint8_t*>(from)[i];
        const auto place = static_cast<uint16_t>(address + i);
        if (seen(place) != value) queue_.push_back({place, value});
    }
    begin();
    return core::Status::ok;
}

void EepromChip::begin() {
    if (writing() || queue_.empty() || now_us_ < beginsAt_us()) return;
    written_us_ = now_us_ + kByte_us;
    spoilt_ = endangered_;
}

void EepromChip::restart() {
    if (writing()) cells_[queue_.front().address] = queue_.front().value;
    queue_.clear();
    writes_ = 0;
    written_us_ = UINT64_MAX;
    patience_until_us_ = rest_until_us_ = 0;
}

uint64_t EepromChip::due_us() const {
    if (writing()) return written_us_;
    return queue_.empty() ? UINT64_MAX : beginsAt_us();
}

void EepromChip::run() {
    if (writing() && now_us_ >= written_us_) {
        const Write& write = queue_.front();
        const auto becomes = spoilt_ ? static_cast<uint8_t>(random_.bits()) : write.value;
        cells_[write.address] = worn_.written(write.address, becomes);
        written_us_ = UINT64_MAX;
        if (cells_[write.address] == write.value || ++writes_ == hal::kEepromWrites) {
            queue_.pop_front();
            writes_ = 0;
        } else if (writes_ > 1) {
            rest_until_us_ = now_us_ + kRest_us;
        }
    }
    begin();
}

}  // namespace simulator
