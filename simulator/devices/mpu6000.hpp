// SPDX-License-Identifier: GPL-3.0-or-later
// InvenSense MPU-6000 on SPI, register by register (PS-MPU-6000A-00, RM-MPU-6000A-00), mounted as
// on the APM 2: body x = chip y, body y = chip x, body z = -chip z.
#pragma once
#include <array>
#include <cstdint>

#include "simulator/devices/errors.hpp"
#include "simulator/devices/faults.hpp"
#include "simulator/devices/low_pass.hpp"
#include "simulator/devices/random.hpp"

namespace simulator {

struct Truth;

// What became of the samples, so that tests can see one lost or taken twice. A sample is read
// when the last byte of its gyro has been.
struct SampleCount {
    uint64_t made = 0, read = 0, lost = 0, repeated = 0;
};

class Mpu6000 {
public:
    static constexpr uint8_t kRevisionD8 = 0x58, kRevisionC4 = 0x14;

    explicit Mpu6000(uint64_t seed = 1, const SensorErrors& errors = {},
                     uint8_t product_id = kRevisionD8);

    void select(bool chosen, uint64_t now_us);
    uint8_t transfer(uint8_t mosi, uint64_t now_us);
    // The clock of the bytes from now on. Over 1 MHz only the sensors' and the interrupt's
    // registers can be read; another byte arrives as garbage, both ways, and is counted.
    void clock(uint32_t hz) { too_fast_ = hz > 1'100'000; }
    uint64_t bytesTooFast() const { return bytes_too_fast_; }

    bool interruptPin() const { return pin_; }

    // When sample() wants to be called next; UINT64_MAX asleep. World does that.
    uint64_t nextSample_us() const;
    void sample(const Truth& truth, uint64_t now_us);

    // Without power it answers nothing; with it again its registers are at their reset values.
    void power(bool on, uint64_t now_us);

    SampleCount samples() const { return count_; }

    // Lost, it has no supply: it answers nothing, and has forgotten everything when it is back.
    void fail(FaultKind kind, uint64_t now_us, double for_s = 0);

private:
    static constexpr int kRegisters = 128, kAxes = 6;  // accelerometer, then gyro, chip axes

    void powerOn(uint64_t now_us, uint64_t start_us);
    bool answers() const { return powered_ && fault_ != FaultKind::lost; }
    void write(uint8_t reg, uint8_t value, uint64_t now_us);
    uint8_t read(uint8_t reg);
    uint8_t garbled(uint8_t byte);
    void schedule(uint64_t now_us);
    bool asleep() const;
    uint64_t period_us() const;
    void filter(const Truth& truth, uint64_t now_us);
    void measure(double throttle);
    double asFailing(double counts);
    void publish();

    const SensorErrors errors_;
    const uint8_t product_id_;
    Random random_;
    std::array<double, kAxes> bias_{};  // m/s2 and rad/s: as the input of the filters
    std::array<double, kAxes> scale_{};
    std::array<double, kAxes> input_{};  // the truth at the last sample
    std::array<double, kAxes> filtered_axes_{};
    std::array<LowPass, kAxes> low_pass_;
    std::array<uint8_t, kRegisters> registers_{};
    std::array<uint8_t, 14>
        measured_{};  // of the newest sample, while a burst still reads the last
    SampleCount count_;
    uint64_t ready_us_ = 0;          // registers answer from here on
    uint64_t wake_us_ = UINT64_MAX;  // from the first order on: until then it is not obeyed
    uint64_t next_sample_us_ = UINT64_MAX, last_sample_us_ = 0;
    uint64_t pulse_end_us_ = UINT64_MAX;
    FaultKind fault_ = FaultKind::none;
    double failing_s_ = 0;
    uint8_t address_ = 0;
    bool powered_ = true, too_fast_ = false;
    uint64_t bytes_too_fast_ = 0;
    Random line_;
    bool chosen_ = false, addressed_ = false, reading_ = false;
    bool pin_ = false, unread_ = false, waiting_ = false, filtered_ = false;
};

}  // namespace simulator
