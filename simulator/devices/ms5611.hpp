// SPDX-License-Identifier: GPL-3.0-or-later
// Measurement Specialties MS5611-01BA on SPI (data sheet DA5611-01BA03): commands, conversion
// times, PROM with its CRC-4, and raw values that the data sheet's formulas, second order
// included, turn back into pressure and temperature.
#pragma once
#include <array>
#include <cstdint>

#include "simulator/devices/errors.hpp"
#include "simulator/devices/faults.hpp"
#include "simulator/devices/random.hpp"

namespace simulator {

class Ms5611 {
public:
    using Prom = std::array<uint16_t, 8>;

    explicit Ms5611(uint64_t seed = 1, const SensorErrors& errors = {});

    void select(bool chosen, uint64_t now_us);
    uint8_t transfer(uint8_t mosi, uint64_t now_us);

    // The air at its port from now on, and the chip's own temperature. World does that.
    void sense(double pressure_pa, double temperature_c);

    void fail(FaultKind kind, double for_s = 0) { fault_.fail(kind, for_s); }

    void power(bool on, uint64_t now_us);  // on, it loads its PROM first

    Prom& prom() { return prom_; }  // for tests to damage
    static uint8_t crc4(Prom prom);

private:
    enum class Quantity { pressure, temperature };

    void command(uint8_t byte, uint64_t now_us);
    void convert(Quantity quantity, int oversampling, uint64_t now_us);
    void answer(uint32_t value, int bytes);
    double rawTemperature() const;
    double rawPressure(double pressure_pa) const;
    double wrongPressure_pa(uint64_t now_us);

    const SensorErrors errors_;
    Random random_;
    Wander drift_;
    FaultyValue fault_;
    Prom prom_;
    double pressure_pa_ = 101325, temperature_c_ = 25;
    uint64_t drift_us_ = 0;
    uint64_t ready_us_ = 0, converted_us_ = UINT64_MAX;
    uint32_t result_ = 0;
    std::array<uint8_t, 3> answer_{};
    unsigned answered_ = 0, answer_size_ = 0;
    bool powered_ = true;
    bool chosen_ = false, first_byte_ = false;
};

}  // namespace simulator
