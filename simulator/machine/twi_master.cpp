// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/twi_master.hpp"

#include "simulator/machine/registers.hpp"

namespace simulator {
namespace {

enum : uint8_t { kInt = 0x80, kAck = 0x40, kStart = 0x20, kStop = 0x10, kEnable = 0x04 };
enum : uint8_t { kNoState = 0xF8, kPrescaler = 0x03 };
constexpr int kByteBits = 9;

}  // namespace

TwiMaster::TwiMaster(avr_t* avr)
    : avr_(avr), io_(findPeripheral<avr_twi_t>(avr, "twi")), interrupt_(avr, &io_->twi, this) {
    hookWrite<&TwiMaster::control>(avr, kTwcr, this);
    hookWrite<&TwiMaster::store>(avr, kTwdr, this);
    hookWrite<&TwiMaster::prescale>(avr, kTwsr, this);
    hookRead<&TwiMaster::plain>(avr, kTwdr, this);
}

void TwiMaster::reset() {
    disable();
    avr_->data[kTwsr] = kNoState;
    avr_->data[kTwcr] = 0;
    avr_->data[kTwdr] = 0xFF;
}

// Datasheet 24.5.2.
uint64_t TwiMaster::bitCycles() const {
    return 16 + (2ull * avr_->data[kTwbr] << 2 * (avr_->data[kTwsr] & kPrescaler));
}

void TwiMaster::prescale(uint16_t address, uint8_t value) {
    avr_->data[address] =
        static_cast<uint8_t>((avr_->data[address] & kNoState) | (value & kPrescaler));
}

void TwiMaster::disable() {
    stopTimer<&TwiMaster::happened>(avr_, this);
    stopTimer<&TwiMaster::stopped>(avr_, this);
    if (device_) device_->stop();
    device_ = nullptr;
    phase_ = Phase::idle;
    stopping_ = false;
    avr_->data[kTwsr] |= kNoState;
}

void TwiMaster::stop() {
    disable();
    stopping_ = true;
    if (!hung_) startTimer<&TwiMaster::stopped>(avr_, bitCycles(), this);
}

uint64_t TwiMaster::stopped(uint64_t) {
    stopping_ = false;
    avr_->data[kTwcr] &= static_cast<uint8_t>(~kStop);
    if (avr_->data[kTwcr] & kStart) proceed(avr_->data[kTwcr]);
    return 0;
}

void TwiMaster::control(uint16_t address, uint8_t value) {
    uint8_t& now = avr_->data[address];
    const bool go = value & kInt;  // a one clears the flag and lets the bus go on
    now = static_cast<uint8_t>((value & ~kInt) | (go ? 0 : now & kInt) | (stopping_ ? kStop : 0));
    if (!(value & kEnable)) {
        disable();
        now &= static_cast<uint8_t>(~(kInt | kStop));
    }
    interrupt_.refresh();
    if (!go || !(value & kEnable) || stopping_) return;  // a start waits for the stop
    if (value & kStop) {
        stop();
    } else {
        proceed(value);
    }
}

void TwiMaster::proceed(uint8_t control) {
    if (control & kStart) {
        later(1, phase_ == Phase::idle ? 0x08 : 0x10);
        phase_ = Phase::started;
        return;
    }
    const uint8_t data = avr_->data[kTwdr];
    if (phase_ == Phase::started) {
        address(data);
    } else if (phase_ == Phase::writing) {
        later(kByteBits, device_ && device_->write(data) ? 0x28 : 0x30);
    } else if (phase_ == Phase::reading) {
        const bool ack = control & kAck;
        avr_->data[kTwdr] = device_ ? device_->read(ack) : 0xFF;
        later(kByteBits, ack ? 0x50 : 0x58);
    }
}

void TwiMaster::address(uint8_t value) {
    const bool read = value & 1;
    const auto found = devices_.find(value >> 1);
    device_ = found == devices_.end() ? nullptr : &found->second;
    if (device_ && !device_->start(read)) device_ = nullptr;
    phase_ = read ? Phase::reading : Phase::writing;
    if (read) {
        later(kByteBits, device_ ? 0x40 : 0x48);
    } else {
        later(kByteBits, device_ ? 0x18 : 0x20);
    }
}

void TwiMaster::later(int bits, uint8_t status) {
    next_status_ = status;
    if (!hung_) startTimer<&TwiMaster::happened>(avr_, bits * bitCycles(), this);
}

uint64_t TwiMaster::happened(uint64_t) {
    avr_->data[kTwsr] = static_cast<uint8_t>((avr_->data[kTwsr] & kPrescaler) | next_status_);
    avr_->data[kTwcr] |= kInt;
    interrupt_.refresh();
    return 0;
}

}  // namespace simulator
