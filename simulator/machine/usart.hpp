// SPDX-License-Identifier: GPL-3.0-or-later
// A USART in place of libsimavr's, whose bit time is wrong: double-buffered transmitter, receiver
// with two bytes of buffer and one in the shift register, and SPI master mode
// (datasheet 22 and 23). Frames are of 8 data bits; parity and 9th bit only cost their time.
#pragma once
#include <simavr/avr_uart.h>

#include <functional>

#include "simulator/machine/level_interrupt.hpp"

namespace simulator {

class Usart : public Mend {
public:
    Usart(avr_t* avr, char name);
    void reset() override;

    // The line: a byte has gone out whole, at this cycle; a byte has come in whole, now.
    std::function<void(uint8_t byte, uint64_t cycle)> on_sent;
    void receive(uint8_t byte);

    // The other end in SPI master mode: a byte for a byte.
    std::function<uint8_t(uint8_t byte)> on_exchange;

    uint64_t byteCycles() const;  // start bit to the end of the stop bit; SPI: eight clocks
    uint32_t baud() const;
    bool receiving() const;

private:
    bool spiMaster() const;
    bool clockGiven() const;
    bool received() const { return fifo_used_ > 0; }
    bool roomToSend() const { return !buffer_full_; }
    void control(uint16_t, uint8_t value);
    void status(uint16_t, uint8_t value);
    void load(uint16_t, uint8_t value);
    uint8_t take(uint16_t);
    uint8_t plain(uint16_t address) { return avr_->data[address]; }
    void showStatus();
    void begin(uint8_t byte);
    uint64_t shifted(uint64_t due);

    avr_t* avr_;
    int number_;
    avr_uart_t* io_;
    LevelInterrupt<Usart, &Usart::received> receive_interrupt_;
    LevelInterrupt<Usart, &Usart::roomToSend> empty_interrupt_;
    uint8_t fifo_[3] = {};
    int fifo_used_ = 0;
    bool overrun_ = false;
    bool shifting_ = false, buffer_full_ = false;
    uint8_t shift_ = 0, buffer_ = 0;
};

}  // namespace simulator
