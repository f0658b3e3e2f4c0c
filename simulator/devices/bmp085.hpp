// SPDX-License-Identifier: GPL-3.0-or-later
// Bosch BMP085 on I2C (data sheet BST-BMP085-DS000): calibration words, conversions with their
// longest times, and raw values that the data sheet's formulas turn back into pressure and
// temperature.
#pragma once
#include <array>
#include <cstdint>

#include "simulator/devices/errors.hpp"
#include "simulator/devices/faults.hpp"
#include "simulator/devices/random.hpp"

namespace simulator {

class Bmp085 {
public:
    static constexpr uint8_t kAddress = 0x77;
    // AC1..AC6, B1, B2, MB, MC, MD
    using Words = std::array<int, 11>;

    explicit Bmp085(uint64_t seed = 1, const SensorErrors& errors = {});

    // Answers whether it acknowledges: it does unless unplugged.
    bool start(bool read, uint64_t now_us);
    bool write(uint8_t byte, uint64_t now_us);
    uint8_t read(bool ack, uint64_t now_us);
    void stop(uint64_t) { pointer_next_ = false; }

    // Its pin EOC, high but for the time of a conversion (chapter 3.3); and when it goes high.
    bool conversionEnded(uint64_t now_us) const {
        return !silent() && (converted_us_ == UINT64_MAX || now_us >= converted_us_);
    }
    uint64_t conversionEnds_us() const { return converted_us_; }

    // The air at its port from now on, and the chip's own temperature. World does that.
    void sense(double pressure_pa, double temperature_c);

    void fail(FaultKind kind, double for_s = 0) {
        fault_.fail(kind, for_s);
        unplug(fault_.lost());
    }

    Words& words() { return words_; }  // for tests to damage
    void unplug(bool unplugged) { unplugged_ = unplugged; }
    void power(bool on, uint64_t now_us);

private:
    bool silent() const { return unplugged_ || !powered_; }
    void control(uint8_t value, uint64_t now_us);
    void advance(uint64_t now_us);
    uint8_t readRegister(uint8_t at) const;
    double pressure_pa(double raw, double b5, int oversampling) const;
    double b5Of(double raw) const;
    double rawTemperature() const;
    uint32_t rawPressure(double pressure_pa, int oversampling) const;
    double wrongPressure_pa(uint64_t now_us);

    const SensorErrors errors_;
    Random random_;
    Wander drift_;
    FaultyValue fault_;
    Words words_;
    double pressure_pa_ = 101325, temperature_c_ = 25;
    uint64_t drift_us_ = 0, converted_us_ = UINT64_MAX;
    static constexpr uint32_t kNoResult = 0x800000;
    uint32_t next_ = kNoResult, result_ = kNoResult;  // 24 bits
    uint8_t control_ = 0, pointer_ = 0;
    bool pointer_next_ = false, unplugged_ = false, powered_ = true;
    uint64_t ready_us_ = 0;
};

}  // namespace simulator
