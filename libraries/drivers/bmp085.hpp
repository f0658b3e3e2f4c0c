// SPDX-License-Identifier: GPL-3.0-or-later
// Bosch BMP085 barometer on I2C (data sheet BST-BMP085-DS000): a temperature, then four pressures.
// The bus works by interrupts, so a step only starts a transfer or fetches the end of one.
#pragma once
#include <stdint.h>

#include "drivers/bmp085_compensation.hpp"

namespace drivers {

class Bmp085 {
public:
    void start() {}
    // Every frame of 10 ms. True: a new pressure is there.
    bool step(uint32_t now_us);

    int32_t pressure_pa() const { return pressure_pa_; }
    int32_t temperature_cc() const { return compensation_.temperature_dc() * 10; }  // 0.01 C
    bool healthy() const { return healthy_; }
    uint16_t badReads() const { return bad_reads_; }
    uint16_t restarts() const { return restarts_; }

private:
    enum class State : uint8_t { identify, load, convert, read };

    void begin(uint32_t now_us);
    bool finish(const uint8_t* bytes, uint32_t now_us);
    bool use(const uint8_t* bytes, uint32_t now_us);
    void takeWords(const uint8_t* bytes, uint32_t now_us);
    bool good(int32_t value, int32_t least, int32_t most, uint32_t now_us);
    void bad(uint32_t now_us);
    void fail(uint32_t now_us);

    Bmp085Compensation compensation_;
    uint16_t words_[Bmp085Compensation::kWords] = {};
    int32_t pressure_pa_ = 0;
    uint32_t since_us_ = 0;  // the wait begins here
    uint32_t wait_us_ = 0;
    uint32_t good_us_ = 0;
    uint16_t bad_reads_ = 0;
    uint16_t restarts_ = 0;
    State state_ = State::identify;
    uint8_t phase_ = 0;  // of the conversion: 0 temperature, then pressures; part of the EEPROM
    uint8_t expected_bytes_ = 0;
    uint8_t bad_in_a_row_ = 0;
    bool under_way_ = false;
    bool healthy_ = false;
};

}  // namespace drivers
