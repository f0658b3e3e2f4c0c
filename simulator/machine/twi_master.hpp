// SPDX-License-Identifier: GPL-3.0-or-later
// The two-wire interface as a bus master, in place of libsimavr's, which answers addresses with the
// wrong status and ignores the bit rate (datasheet 24: figure 24-11, tables 24-2 and 24-3).
#pragma once
#include <simavr/avr_twi.h>

#include <functional>
#include <map>

#include "simulator/devices/line_fault.hpp"
#include "simulator/machine/level_interrupt.hpp"

namespace simulator {

// A device on the bus; each call is one element of a transfer.
struct TwiDevice {
    std::function<bool(bool read)> start;  // its address was called: acknowledge?
    std::function<bool(uint8_t)> write;    // acknowledge?
    std::function<uint8_t(bool ack)> read;
    std::function<void()> stop;
};

class TwiMaster : public Mend {
public:
    explicit TwiMaster(avr_t* avr);
    void reset() override;

    void connect(uint8_t address, TwiDevice device) { devices_[address] = std::move(device); }
    // SCL held low stops everything until it is released. SDA held low lets no transfer begin or
    // end; one under way loses the arbitration with its first one bit, or reads zeros. Noise turns
    // bits over, or is taken for a start or stop where none may be.
    void fail(FaultKind kind);
    // As with SDA held low: a device that has lost count.
    void hang(bool hung) { fail(hung ? FaultKind::sda_low : FaultKind::none); }
    uint64_t bitCycles() const;
    // Of SCL, which nobody drives high: its pull-up charges the wires, and the high half of a bit
    // is counted from when the line is high (datasheet 24.4).
    void rise(double ns);

private:
    enum class Phase { idle, started, writing, reading, refused };

    bool flag() const { return avr_->data[io_->r_twcr] & 0x80; }
    void control(uint16_t address, uint8_t value);
    void store(uint16_t address, uint8_t value) { avr_->data[address] = value; }
    void prescale(uint16_t address, uint8_t value);
    uint8_t plain(uint16_t address) { return avr_->data[address]; }
    void disable();
    void stop();
    void address(uint8_t value);
    void proceed(uint8_t control);
    void later(int bits, uint8_t status);
    void wait();
    bool held() const;
    void write(uint8_t data);
    uint64_t happened(uint64_t);
    uint64_t stopped(uint64_t);

    avr_t* avr_;
    avr_twi_t* io_;
    LevelInterrupt<TwiMaster, &TwiMaster::flag> interrupt_;
    std::map<uint8_t, TwiDevice> devices_;
    TwiDevice* device_ = nullptr;
    Phase phase_ = Phase::idle;
    uint8_t next_status_ = 0;
    bool stopping_ = false;
    LineFault line_{1};
    uint64_t rise_cycles_ = 0;
    uint64_t waiting_ = 0;  // cycles of what is under way, while the line is held
};

}  // namespace simulator
