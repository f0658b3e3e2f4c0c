// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/spi_master.hpp"

#include "simulator/machine/level_interrupt.hpp"
#include "simulator/machine/registers.hpp"

namespace simulator {

enum : uint8_t { kSpie = 0x80, kSpe = 0x40, kMstr = 0x10, kSpif = 0x80, kWcol = 0x40, k2x = 0x01 };

SpiMaster::SpiMaster(avr_t* avr) : avr_(avr), io_(findPeripheral<avr_spi_t>(avr, "spi")) {
    hookWrite<&SpiMaster::control>(avr, kSpcr, this);
    hookWrite<&SpiMaster::status>(avr, kSpsr, this);
    hookWrite<&SpiMaster::begin>(avr, kSpdr, this);
    hookRead<&SpiMaster::readStatus>(avr, kSpsr, this);
    hookRead<&SpiMaster::readData>(avr, kSpdr, this);
}

void SpiMaster::reset() {
    shifting_ = flag_seen_ = false;
    stopTimer<&SpiMaster::finished>(avr_, this);
}

void SpiMaster::control(uint16_t address, uint8_t value) {
    avr_->data[address] = value;
    const bool flag = avr_->data[kSpsr] & kSpif;
    if ((value & kSpie) && flag && !io_->spi.pending) requestInterrupt(avr_, &io_->spi);
    if (!(value & kSpe)) reset();
}

void SpiMaster::status(uint16_t address, uint8_t value) {
    avr_->data[address] =
        static_cast<uint8_t>((avr_->data[address] & (kSpif | kWcol)) | (value & k2x));
}

uint64_t SpiMaster::byteCycles() const {
    constexpr uint8_t kDivider[] = {4, 16, 64, 128};  // datasheet table 21-5
    const int divider = kDivider[avr_->data[kSpcr] & 3];
    return 8u * (avr_->data[kSpsr] & k2x ? divider / 2 : divider);
}

uint32_t SpiMaster::clock_hz() const { return static_cast<uint32_t>(8 * kClock_hz / byteCycles()); }

void SpiMaster::begin(uint16_t, uint8_t value) {
    constexpr uint8_t kMaster = kSpe | kMstr;
    if ((avr_->data[kSpcr] & kMaster) != kMaster) return;
    acknowledge();
    if (shifting_) {
        avr_->data[kSpsr] |= kWcol;
        return;
    }
    shifting_ = true;
    mosi_ = value;
    startTimer<&SpiMaster::finished>(avr_, byteCycles(), this);
}

uint64_t SpiMaster::finished(uint64_t) {
    shifting_ = flag_seen_ = false;
    received_ = on_exchange ? on_exchange(mosi_) : 0xFF;
    avr_raise_interrupt(avr_, &io_->spi);
    return 0;
}

uint8_t SpiMaster::readStatus(uint16_t address) {
    flag_seen_ = avr_->data[address] & (kSpif | kWcol);
    return avr_->data[address];
}

uint8_t SpiMaster::readData(uint16_t) {
    acknowledge();
    return received_;
}

void SpiMaster::acknowledge() {
    if (!flag_seen_) return;
    flag_seen_ = false;
    avr_clear_interrupt(avr_, &io_->spi);
    avr_->data[kSpsr] &= k2x;
}

}  // namespace simulator
