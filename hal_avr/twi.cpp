// SPDX-License-Identifier: GPL-3.0-or-later
// The I2C master as a table of what the hardware reports (data sheet 24.7, tables 24-3 and 24-4)
// and what is done next, one interrupt a byte.
#include <avr/interrupt.h>
#include <avr/io.h>
#include <string.h>
#include <util/delay.h>
#include <util/twi.h>

#include "hal/clock.hpp"
#include "hal/i2c.hpp"
#include "pin.hpp"
#include "start.hpp"
#include "wiring.hpp"

namespace {

using Clock = avr::Pin<avr::PortD, 0>;
using Data = avr::Pin<avr::PortD, 1>;

constexpr uint8_t dividerFor(uint32_t hz) { return static_cast<uint8_t>((F_CPU / hz - 16) / 2); }
constexpr uint8_t kFast = dividerFor(400000);
constexpr uint8_t kSlow = dividerFor(100000);
constexpr uint16_t kLongest_us = 5000;

constexpr uint8_t kOn = 1 << TWEN;
constexpr uint8_t kGo = (1 << TWINT) | (1 << TWEN) | (1 << TWIE);
constexpr uint8_t kStart = kGo | (1 << TWSTA);
constexpr uint8_t kStop = (1 << TWINT) | (1 << TWEN) | (1 << TWSTO);

enum class State : uint8_t { idle, running, done, failed };

struct Transfer {
    uint8_t bytes[hal::kI2cBytes];  // first those to send, then those received
    uint8_t address_rw;
    uint8_t at, out_size, in_size;
    volatile State state;
    uint32_t started_us;
};
Transfer transfers[wiring::kI2cUsers];
Transfer* on_the_bus = transfers;  // running, or the last

// Who has found the bus taken so many times in a row goes next, or one that comes first in every
// frame would keep it from the other for ever. The others are refused meanwhile, but not for ever.
struct Turn {
    const Transfer* waits;
    uint8_t refused;  // times: first it, then the others
};
Turn turn;
constexpr uint8_t kPatience = 5, kGivesUp = kPatience + 4;

bool mustWait(const Transfer& transfer, bool taken) {
    if (wiring::kI2cUsers == 1) return taken;
    if (turn.waits != &transfer && turn.refused >= kPatience && turn.refused < kGivesUp) {
        ++turn.refused;
        return true;
    }
    if (!taken) {
        if (turn.waits == &transfer || turn.refused >= kGivesUp) turn = Turn();
    } else if (turn.waits == &transfer) {
        ++turn.refused;
    } else {
        turn = {&transfer, 1};
    }
    return taken;
}

inline __attribute__((always_inline)) Transfer& transferOf(uint8_t user) {
    return transfers[wiring::kI2cUsers == 1 ? 0 : user];
}

inline void finish(Transfer& transfer, State how) {
    transfer.state = how;
    TWCR = kStop;
}

inline void sendNext(Transfer& transfer) {
    if (transfer.at < transfer.out_size) {
        TWDR = transfer.bytes[transfer.at++];
        TWCR = kGo;
    } else if (transfer.in_size > 0) {
        transfer.address_rw |= TW_READ;
        TWCR = kStart;
    } else {
        finish(transfer, State::done);
    }
}

// Every byte but the last is acknowledged.
inline __attribute__((always_inline)) void receiveNext(const Transfer& transfer) {
    const uint8_t next = transfer.at + 1;
    const bool more = next < transfer.in_size;
    TWCR = more ? kGo | (1 << TWEA) : kGo;
}

inline void storeByte(Transfer& transfer) { transfer.bytes[transfer.at++] = TWDR; }

// Without the pointer where there is but one.
inline __attribute__((always_inline)) Transfer& current() {
    return wiring::kI2cUsers == 1 ? transfers[0] : *on_the_bus;
}

// An open-collector line: pulled low, or left to its pull-ups.
template <class Line>
void pull() {
    Line::low();
    Line::output();
}
template <class Line>
void release() {
    Line::input();
    Line::high();
}

// Nine clocks let a device that was cut off in the middle of a byte finish it; then a stop.
void freeBus() {
    constexpr double kHalf_us = 5;
    TWCR = 0;
    for (uint8_t i = 0; i < 9; ++i) {
        pull<Clock>();
        _delay_us(kHalf_us);
        release<Clock>();
        _delay_us(kHalf_us);
    }
    pull<Clock>();
    pull<Data>();
    _delay_us(kHalf_us);
    release<Clock>();
    _delay_us(kHalf_us);
    release<Data>();
    _delay_us(kHalf_us);
    avr::twiStart();
}

}  // namespace

ISR(TWI_vect) {
    Transfer& transfer = current();
    switch (TW_STATUS) {
        case TW_START:
        case TW_REP_START:
            transfer.at = 0;
            TWDR = transfer.address_rw;
            TWCR = kGo;
            break;
        case TW_MT_SLA_ACK:
        case TW_MT_DATA_ACK:
            sendNext(transfer);
            break;
        case TW_MR_SLA_ACK:
            receiveNext(transfer);
            break;
        case TW_MR_DATA_ACK:
            storeByte(transfer);
            receiveNext(transfer);
            break;
        case TW_MR_DATA_NACK:
            storeByte(transfer);
            finish(transfer, State::done);
            break;
        default:  // nobody answered, somebody else sends, or the bus is in disorder
            finish(transfer, State::failed);
            break;
    }
}

namespace avr {

void twiStart() {
    Clock::high();
    Data::high();
    TWSR = 0;
    if (TWBR != kSlow) TWBR = kFast;
    TWCR = kOn;
}

}  // namespace avr

namespace hal {

bool i2cStart(I2cUser user, uint8_t address, const uint8_t* out, uint8_t out_size,
              uint8_t in_size) {
    if (out_size > kI2cBytes || in_size > kI2cBytes) return false;
    Transfer& transfer = transferOf(static_cast<uint8_t>(user));
    const bool taken = current().state == State::running || (TWCR & (1 << TWSTO));
    if (mustWait(transfer, taken)) return false;
    if (wiring::kI2cUsers > 1) on_the_bus = &transfer;
    memcpy(transfer.bytes, out, out_size);
    transfer.address_rw = static_cast<uint8_t>(address << 1);
    if (out_size == 0) transfer.address_rw |= TW_READ;
    transfer.out_size = out_size;
    transfer.in_size = in_size;
    transfer.state = State::running;
    transfer.started_us = now_us();
    TWCR = kStart;
    return true;
}

core::Status i2cResult(I2cUser user, uint8_t* in, uint8_t in_size) {
    Transfer& transfer = transferOf(static_cast<uint8_t>(user));
    const State state = transfer.state;
    if (state == State::idle) return core::Status::timeout;
    const bool stopping = (TWCR & (1 << TWSTO)) && &transfer == &current();
    if (state == State::running || stopping) {
        if (now_us() - transfer.started_us < kLongest_us) return core::Status::busy;
        TWBR = kSlow;
        freeBus();
        transfer.state = State::idle;
        return core::Status::timeout;
    }
    transfer.state = State::idle;
    if (state == State::failed) {
        TWBR = kSlow;
        return core::Status::timeout;
    }
    memcpy(in, transfer.bytes, in_size);
    return core::Status::ok;
}

}  // namespace hal
