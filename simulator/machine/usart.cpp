// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/usart.hpp"

#include "simulator/machine/registers.hpp"

namespace simulator {
namespace {

enum : uint8_t { kRxc = 0x80, kTxc = 0x40, kUdre = 0x20, kDor = 0x08, kU2x = 0x02, kMpcm = 0x01 };
enum : uint8_t { kRxen = 0x10, kTxen = 0x08, kNinthBit = 0x04 };
constexpr uint8_t kOwnBits = kU2x | kMpcm;

// Where the clock pins XCK0..3 are made outputs: PE2, PD5, PH2, PJ2.
struct ClockPin {
    uint16_t direction;
    uint8_t mask;
};
constexpr ClockPin kClockPins[] = {
    {0x2D, 1 << 2}, {0x2A, 1 << 5}, {0x101, 1 << 2}, {0x104, 1 << 2}};

}  // namespace

Usart::Usart(avr_t* avr, char name)
    : avr_(avr),
      number_(name - '0'),
      io_(findPeripheral<avr_uart_t>(avr, "uart", name)),
      receive_interrupt_(avr, &io_->rxc, this),
      empty_interrupt_(avr, &io_->udrc, this) {
    hookWrite<&Usart::status>(avr, io_->r_ucsra, this);
    hookRead<&Usart::plain>(avr, io_->r_ucsra, this);  // the library's lets the host sleep here
    hookWrite<&Usart::control>(avr, io_->r_ucsrb, this);
    hookWrite<&Usart::load>(avr, io_->r_udr, this);
    hookRead<&Usart::take>(avr, io_->r_udr, this);
}

void Usart::reset() {
    fifo_used_ = 0;
    overrun_ = shifting_ = buffer_full_ = false;
    avr_->data[io_->r_ucsra] = kUdre;
    avr_->data[io_->r_ucsrb] = 0;
    avr_->data[io_->r_ucsrc] = 0x06;
    stopTimer<&Usart::shifted>(avr_, this);
}

bool Usart::spiMaster() const { return avr_->data[io_->r_ucsrc] >> 6 == 3; }

// Datasheet 22.3 and 23.2: with XCK an input the clock is to come from outside.
bool Usart::clockGiven() const {
    return avr_->data[kClockPins[number_].direction] & kClockPins[number_].mask;
}

bool Usart::receiving() const { return avr_->data[io_->r_ucsrb] & kRxen; }

// Datasheet tables 22-1 and 23-1: clocks per bit; 22.4: the frame's bits.
uint64_t Usart::byteCycles() const {
    const uint8_t b = avr_->data[io_->r_ucsrb], c = avr_->data[io_->r_ucsrc];
    const uint8_t high = avr_->data[io_->ubrrh.reg] & 15, low = avr_->data[io_->ubrrl.reg];
    const uint32_t divider = (high << 8 | low) + 1;
    if (spiMaster()) return 2 * divider * 8;
    const int data = b & kNinthBit ? 9 : 5 + (c >> 1 & 3), parity = c & 0x20 ? 1 : 0;
    const int stop = c & 0x08 ? 2 : 1;
    const bool fast = avr_->data[io_->r_ucsra] & kU2x;
    return uint64_t{divider} * (fast ? 8 : 16) * (1 + data + parity + stop);
}

uint32_t Usart::baud() const { return static_cast<uint32_t>(kClock_hz * 10ull / byteCycles()); }

void Usart::receive(uint8_t byte) {
    if (!receiving()) return;
    if (fifo_used_ == 3) {
        overrun_ = true;
    } else {
        fifo_[fifo_used_++] = byte;
    }
    showStatus();
}

uint8_t Usart::take(uint16_t) {
    const uint8_t byte = fifo_[0];
    if (fifo_used_ > 0) {
        fifo_[0] = fifo_[1];
        fifo_[1] = fifo_[2];
        fifo_used_--;
    }
    overrun_ = false;
    showStatus();
    return byte;
}

void Usart::showStatus() {
    uint8_t& a = avr_->data[io_->r_ucsra];
    a = static_cast<uint8_t>((a & (kOwnBits | kTxc)) | (fifo_used_ ? kRxc : 0) |
                             (buffer_full_ ? 0 : kUdre) | (overrun_ ? kDor : 0));
    receive_interrupt_.refresh();
    empty_interrupt_.refresh();
}

void Usart::status(uint16_t address, uint8_t value) {
    uint8_t& a = avr_->data[address];
    if (value & kTxc) avr_clear_interrupt(avr_, &io_->txc);
    a = static_cast<uint8_t>((a & ~kOwnBits) | (value & kOwnBits));
}

void Usart::control(uint16_t address, uint8_t value) {
    avr_->data[address] = value;
    if (!(value & kRxen)) fifo_used_ = 0;
    showStatus();
    const bool done = avr_->data[io_->r_ucsra] & kTxc;
    if (done && avr_regbit_get(avr_, io_->txc.enable) && !io_->txc.pending)
        requestInterrupt(avr_, &io_->txc);
}

void Usart::load(uint16_t, uint8_t value) {
    if (!(avr_->data[io_->r_ucsrb] & kTxen) || buffer_full_) return;
    if (shifting_) {
        buffer_ = value;
        buffer_full_ = true;
        showStatus();
    } else {
        begin(value);
    }
}

void Usart::begin(uint8_t byte) {
    shift_ = byte;
    shifting_ = true;
    if (spiMaster() && !clockGiven()) return;  // for ever
    startTimer<&Usart::shifted>(avr_, byteCycles(), this);
}

uint64_t Usart::shifted(uint64_t due) {
    const uint8_t sent = shift_;
    shifting_ = buffer_full_;
    shift_ = buffer_;
    buffer_full_ = false;
    if (spiMaster()) {
        receive(on_exchange ? on_exchange(sent) : 0xFF);
    } else if (on_sent) {
        on_sent(sent, due);
    }
    if (!shifting_) avr_raise_interrupt(avr_, &io_->txc);
    showStatus();
    return shifting_ ? due + byteCycles() : 0;
}

}  // namespace simulator
