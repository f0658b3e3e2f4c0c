// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/eeprom.hpp"

#include <algorithm>

#include "simulator/machine/registers.hpp"
#include "simulator/machine/wait.hpp"

namespace simulator {

enum : uint8_t { kRead = 0x01, kWrite = 0x02, kMaster = 0x04 };
// Datasheet table 8-1, by EEPM1:0: erase and write, erase only, write only.
constexpr uint64_t kTime[] = {3400 * kCyclesPer_us, 1800 * kCyclesPer_us, 1800 * kCyclesPer_us,
                              3400 * kCyclesPer_us};

Eeprom::Eeprom(avr_t* avr)
    : avr_(avr),
      io_(findPeripheral<avr_eeprom_t>(avr, "eeprom")),
      ready_interrupt_(avr, &io_->ready, this) {
    hookWrite<&Eeprom::control>(avr, kEecr, this);
    hookRead<&Eeprom::readControl>(avr, kEecr, this);
}

void Eeprom::reset() {
    enabled_until_ = 0;
    if (!busy_) return;
    avr_->data[kEecr] |= kWrite;
    startTimerAt<&Eeprom::written>(avr_, done_, this);
}

std::vector<uint8_t> Eeprom::contents() const { return {io_->eeprom, io_->eeprom + io_->size}; }

void Eeprom::setContents(const std::vector<uint8_t>& image) {
    std::fill(io_->eeprom, io_->eeprom + io_->size, 0xFF);
    std::copy_n(image.begin(), std::min<size_t>(image.size(), io_->size), io_->eeprom);
}

void Eeprom::control(uint16_t address, uint8_t value) {
    uint8_t& now = avr_->data[address];
    const bool enabled = (now & kMaster) && avr_->cycle <= enabled_until_;
    // SBI takes two cycles, then the window of four opens.
    if ((value & kMaster) && !(now & kMaster)) enabled_until_ = avr_->cycle + 6;
    now = static_cast<uint8_t>((value & ~(kRead | kWrite)) | (now & kWrite));
    if ((value & kRead) && !busy_) {
        avr_->data[kEedr] = io_->eeprom[(avr_->data[kEearl] | avr_->data[kEearh] << 8) & 0xFFF];
        wait(avr_, 4);
    }
    if ((value & kWrite) && enabled && !busy_) beginWrite();
    if (avr_->cycle > enabled_until_) now &= static_cast<uint8_t>(~kMaster);
    ready_interrupt_.refresh();
}

uint8_t Eeprom::readControl(uint16_t address) {
    if (avr_->cycle > enabled_until_) avr_->data[address] &= static_cast<uint8_t>(~kMaster);
    return avr_->data[address];
}

void Eeprom::beginWrite() {
    uint8_t& now = avr_->data[kEecr];
    const int mode = now >> 4 & 3;
    now = static_cast<uint8_t>((now & ~kMaster) | kWrite);
    address_ = (avr_->data[kEearl] | avr_->data[kEearh] << 8) & 0xFFF;
    const uint8_t before = io_->eeprom[address_], data = avr_->data[kEedr];
    value_ = mode == 1 ? 0xFF : mode == 2 ? before & data : data;
    if (mode != 2) io_->eeprom[address_] = 0xFF;
    busy_ = true;
    spoilt_ = endangered_;
    writes_++;
    done_ = avr_->cycle + kTime[mode];
    startTimerAt<&Eeprom::written>(avr_, done_, this);
    wait(avr_, 2);
}

void Eeprom::endanger(bool endangered) {
    endangered_ = endangered;
    if (busy_ && endangered) spoilt_ = true;
}

void Eeprom::breakOff() {
    if (!busy_) return;
    spoilt_ = true;
    written(0);
}

uint64_t Eeprom::written(uint64_t) {
    busy_ = false;
    const auto becomes = spoilt_ ? static_cast<uint8_t>(random_.bits()) : value_;
    io_->eeprom[address_] = worn_.written(address_, becomes);
    avr_->data[kEecr] &= static_cast<uint8_t>(~kWrite);
    ready_interrupt_.refresh();
    return 0;
}

}  // namespace simulator
