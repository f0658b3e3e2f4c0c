// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/twi_master.hpp"

#include <cmath>

#include "simulator/machine/registers.hpp"

namespace simulator {
namespace {

enum : uint8_t { kInt = 0x80, kAck = 0x40, kStart = 0x20, kStop = 0x10, kEnable = 0x04 };
enum : uint8_t { kNoState = 0xF8, kPrescaler = 0x03 };
enum : uint8_t { kBusError = 0x00, kStarted = 0x08, kRepeated = 0x10, kArbitrationLost = 0x38 };
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

void TwiMaster::rise(double ns) {
    rise_cycles_ = static_cast<uint64_t>(std::ceil(ns * 1e-9 * kClock_hz));
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
    waiting_ = 0;
    avr_->data[kTwsr] |= kNoState;
}

// With SDA low neither a start nor a stop is one; with SCL low nothing happens at all.
bool TwiMaster::held() const {
    if (line_.kind() == FaultKind::scl_low) return true;
    const bool edge_of_sda = stopping_ || (phase_ == Phase::started && next_status_ <= kRepeated);
    return line_.kind() == FaultKind::sda_low && edge_of_sda;
}

void TwiMaster::fail(FaultKind kind) {
    if (kind == line_.kind()) return;
    line_.fail(kind);
    if (!held()) wait();
}

// What is under way goes on when nothing holds the lines.
void TwiMaster::wait() {
    if (waiting_ == 0 || held()) return;
    if (stopping_)
        startTimer<&TwiMaster::stopped>(avr_, waiting_, this);
    else
        startTimer<&TwiMaster::happened>(avr_, waiting_, this);
    waiting_ = 0;
}

void TwiMaster::stop() {
    disable();
    stopping_ = true;
    waiting_ = bitCycles();
    wait();
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
        const bool repeated = phase_ != Phase::idle;
        phase_ = Phase::started;
        later(1, repeated ? +kRepeated : +kStarted);
        return;
    }
    const uint8_t data = avr_->data[kTwdr];
    if (phase_ == Phase::started) {
        address(data);
    } else if (phase_ == Phase::writing) {
        write(data);
    } else if (phase_ == Phase::reading) {
        const bool ack = control & kAck;
        avr_->data[kTwdr] = line_.through(device_ ? device_->read(ack) : 0xFF);
        later(kByteBits, ack ? 0x50 : 0x58);
    }
}

// Datasheet table 24-2: what is sent after a refusal is refused as well.
void TwiMaster::write(uint8_t data) {
    const bool lost = line_.kind() == FaultKind::sda_low && data != 0;
    const bool taken = !lost && device_ && device_->write(line_.through(data));
    later(kByteBits, lost ? +kArbitrationLost : taken ? 0x28 : 0x30);
}

// After an address that was refused for reading there is nothing to read (table 24-3).
void TwiMaster::address(uint8_t value) {
    const bool read = value & 1;
    if (line_.kind() == FaultKind::sda_low) return later(kByteBits, kArbitrationLost);
    const auto found = devices_.find(line_.through(value) >> 1);
    device_ = found == devices_.end() ? nullptr : &found->second;
    if (device_ && !device_->start(read)) device_ = nullptr;
    phase_ = !read ? Phase::writing : device_ ? Phase::reading : Phase::refused;
    if (read) {
        later(kByteBits, device_ ? 0x40 : 0x48);
    } else {
        later(kByteBits, device_ ? 0x18 : 0x20);
    }
}

void TwiMaster::later(int bits, uint8_t status) {
    next_status_ = line_.hits() ? +kBusError : status;
    waiting_ = static_cast<uint64_t>(bits) * (bitCycles() + rise_cycles_);
    wait();
}

uint64_t TwiMaster::happened(uint64_t) {
    avr_->data[kTwsr] = static_cast<uint8_t>((avr_->data[kTwsr] & kPrescaler) | next_status_);
    avr_->data[kTwcr] |= kInt;
    interrupt_.refresh();
    return 0;
}

}  // namespace simulator
