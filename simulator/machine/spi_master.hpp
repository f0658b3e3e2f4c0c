// SPDX-License-Identifier: GPL-3.0-or-later
// The SPI as a master with the chip's byte times (libsimavr takes 100 us for each), SPIF, WCOL and
// the receive buffer (datasheet 21).
#pragma once
#include <simavr/avr_spi.h>

#include <functional>

#include "simulator/machine/hooks.hpp"

namespace simulator {

class SpiMaster : public Mend {
public:
    explicit SpiMaster(avr_t* avr);
    void reset() override;

    std::function<uint8_t(uint8_t mosi)> on_exchange;  // at the end of each byte
    uint32_t clock_hz() const;

private:
    void control(uint16_t address, uint8_t value);
    void status(uint16_t address, uint8_t value);
    void begin(uint16_t, uint8_t value);
    uint8_t readStatus(uint16_t address);
    uint8_t readData(uint16_t);
    void acknowledge();
    uint64_t byteCycles() const;
    uint64_t finished(uint64_t);

    avr_t* avr_;
    avr_spi_t* io_;
    bool shifting_ = false;
    bool flag_seen_ = false;  // SPSR was read with SPIF set: the next access to SPDR clears it
    uint8_t mosi_ = 0, received_ = 0;
};

}  // namespace simulator
