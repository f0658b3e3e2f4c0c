// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/mpu6000.hpp"

#include <algorithm>
#include <cmath>

#include "simulator/constants.hpp"
#include "simulator/world.hpp"

namespace simulator {
namespace {

enum Register : uint8_t {
    kProductId = 0x0C,
    kSampleDivider = 0x19,
    kConfig = 0x1A,
    kGyroConfig = 0x1B,
    kAccelConfig = 0x1C,
    kInterruptPin = 0x37,
    kInterruptEnable = 0x38,
    kInterruptStatus = 0x3A,
    kData = 0x3B,  // accelerometer, temperature, gyro: 14 bytes
    kDataEnd = 0x48,
    kLastReadOnly = 0x60,
    kPower1 = 0x6B,
    kPower2 = 0x6C,
    kWhoAmI = 0x75,
};

constexpr uint8_t kReset = 0x80, kSleep = 0x40;                              // of kPower1
constexpr uint8_t kActiveLow = 0x80, kLatch = 0x20, kClearByAnyRead = 0x10;  // of kInterruptPin
constexpr uint8_t kDataReady = 0x01;

constexpr double kTemperature_c = 35;

// PS-MPU-6000A section 6: registers answer 11 ms after power-on as a rule and after 100 ms at the
// latest, which it takes when a supply came back badly; the gyro has settled 30 ms after it was
// woken; register map, register 55: an interrupt not latched is a pulse of 50 us.
constexpr uint64_t kRegistersStart_us = 11'000, kSlowStart_us = 100'000;
constexpr uint64_t kGyroStart_us = 30'000, kPulse_us = 50;
// No document gives it: drivers that have flown these boards write the wake-up up to five times,
// 5 ms apart, until the register no longer reads as asleep.
constexpr uint64_t kWakes_us = 4'000;

struct Bandwidth {
    double accel_hz, gyro_hz, rate_hz;
};
constexpr Bandwidth kBandwidths[8] = {
    // by DLPF_CFG; 7 is reserved and acts as 0
    {260, 256, 8000}, {184, 188, 1000}, {94, 98, 1000}, {44, 42, 1000},
    {21, 20, 1000},   {10, 10, 1000},   {5, 5, 1000},   {260, 256, 8000},
};

// Silicon of revision C has half the sensitivity of later ones.
bool isRevisionC(uint8_t product_id) {
    constexpr uint8_t kRevisionC[] = {0x14, 0x15, 0x54, 0x55};
    return std::find(std::begin(kRevisionC), std::end(kRevisionC), product_id) !=
           std::end(kRevisionC);
}

void putWord(uint8_t* to, double value) {
    const double limited = std::clamp(std::round(value), -32768.0, 32767.0);
    const auto word = static_cast<uint16_t>(static_cast<int16_t>(limited));
    to[0] = static_cast<uint8_t>(word >> 8);
    to[1] = static_cast<uint8_t>(word);
}

std::array<double, 6> chipAxes(const Truth& t) {
    return {t.force_y_mss,     t.force_x_mss,    -t.force_z_mss,
            t.pitch_rate_rads, t.roll_rate_rads, -t.yaw_rate_rads};
}

double combined(double a, double b) { return std::sqrt(a * a + b * b); }

}  // namespace

Mpu6000::Mpu6000(uint64_t seed, const SensorErrors& errors, uint8_t product_id)
    : errors_(errors), product_id_(product_id), random_(seed, 1), line_(seed, 18) {
    for (int axis = 0; axis < kAxes; ++axis) {
        const double deviation =
            axis < 3 ? errors_.accel_bias_g * kGravity_mss : errors_.gyro_bias_dps * kRadians;
        bias_[axis] = deviation * random_.normal();
    }
    Random of_scale(seed, 11);
    for (int axis = 0; axis < kAxes; ++axis)
        scale_[axis] = axis < 3 ? 1 + errors_.accel_scale * of_scale.normal() : 1;
    powerOn(0, kRegistersStart_us);
}

void Mpu6000::powerOn(uint64_t now_us, uint64_t start_us) {
    registers_.fill(0);
    registers_[kPower1] = kSleep;
    registers_[kWhoAmI] = 0x68;
    registers_[kProductId] = product_id_;
    ready_us_ = now_us + start_us;
    wake_us_ = UINT64_MAX;
    unread_ = waiting_ = pin_ = filtered_ = false;
    schedule(now_us);
}

void Mpu6000::select(bool chosen, uint64_t) {
    if (chosen_ == chosen) return;
    chosen_ = chosen;
    addressed_ = reading_ = false;
    if (!chosen && waiting_) publish();
}

uint8_t Mpu6000::transfer(uint8_t mosi, uint64_t now_us) {
    if (!chosen_) return 0xFF;
    if (!answers()) return 0;
    if (!addressed_) {
        addressed_ = true;
        reading_ = mosi & 0x80;
        address_ = mosi & 0x7F;
        return 0;
    }
    const uint8_t reg = address_;
    address_ = (address_ + 1) & 0x7F;
    if (now_us < ready_us_) return 0;
    const bool readable_fast = reading_ && reg >= kInterruptStatus && reg <= kDataEnd;
    if (too_fast_ && !readable_fast) mosi = garbled(mosi);
    if (reading_) return too_fast_ && !readable_fast ? mosi : read(reg);
    write(reg, mosi, now_us);
    return 0;
}

// PS-MPU-6000A, 6.4: 1 MHz +-10 % for all registers.
uint8_t Mpu6000::garbled(uint8_t byte) {
    ++bytes_too_fast_;
    return static_cast<uint8_t>(byte ^ line_.bits());
}

uint8_t Mpu6000::read(uint8_t reg) {
    const uint8_t value = registers_[reg];
    if (reg == kInterruptStatus || (registers_[kInterruptPin] & kClearByAnyRead)) {
        registers_[kInterruptStatus] = 0;
        pin_ = registers_[kInterruptPin] & kActiveLow;
    }
    if (reg == kDataEnd) {
        ++(unread_ ? count_.read : count_.repeated);
        unread_ = false;
    }
    return value;
}

void Mpu6000::write(uint8_t reg, uint8_t value, uint64_t now_us) {
    const bool read_only =
        (reg >= kInterruptStatus && reg <= kLastReadOnly) || reg == kWhoAmI || reg == kProductId;
    if (read_only) return;
    if (reg == kPower1 && (value & kReset)) return powerOn(now_us, kRegistersStart_us);
    const bool was_asleep = asleep();
    if (reg == kPower1 && was_asleep && !(value & kSleep)) {
        wake_us_ = std::min(wake_us_, now_us + kWakes_us);
        if (now_us < wake_us_) return;
    }
    registers_[reg] = value;
    if (reg == kInterruptPin) pin_ = value & kActiveLow;
    if (reg == kPower1 && asleep() != was_asleep) schedule(now_us);
    if (reg == kSampleDivider || reg == kConfig) {
        filtered_ = false;
        next_sample_us_ = std::min(next_sample_us_, std::max(now_us + period_us(), ready_us_));
        if (asleep()) next_sample_us_ = UINT64_MAX;
    }
}

void Mpu6000::schedule(uint64_t now_us) {
    next_sample_us_ = asleep() ? UINT64_MAX : now_us + kGyroStart_us;
    filtered_ = false;
}

bool Mpu6000::asleep() const { return registers_[kPower1] & kSleep; }

uint64_t Mpu6000::period_us() const {
    const double rate_hz = kBandwidths[registers_[kConfig] & 7].rate_hz;
    return static_cast<uint64_t>((1 + registers_[kSampleDivider]) * 1e6 / rate_hz);
}

uint64_t Mpu6000::nextSample_us() const { return std::min(next_sample_us_, pulse_end_us_); }

void Mpu6000::sample(const Truth& truth, uint64_t now_us) {
    if (now_us >= pulse_end_us_) {
        pin_ = registers_[kInterruptPin] & kActiveLow;
        pulse_end_us_ = UINT64_MAX;
    }
    if (now_us < next_sample_us_) return;
    filter(truth, next_sample_us_);
    last_sample_us_ = next_sample_us_;
    next_sample_us_ += period_us();
    measure(truth.throttle);
    ++count_.made;
    if (waiting_) ++count_.lost;  // a burst longer than a sample period
    waiting_ = true;
    if (!(chosen_ && addressed_ && reading_)) publish();
}

// The chip filters at its internal rate; between two samples the truth is taken as a ramp.
void Mpu6000::filter(const Truth& truth, uint64_t now_us) {
    const Bandwidth& bandwidth = kBandwidths[registers_[kConfig] & 7];
    const auto now = chipAxes(truth);
    const auto steps = static_cast<int>((now_us - last_sample_us_) * bandwidth.rate_hz / 1e6 + 0.5);
    for (int axis = 0; axis < kAxes; ++axis) {
        if (!filtered_) {
            low_pass_[axis].tune(axis < 3 ? bandwidth.accel_hz : bandwidth.gyro_hz,
                                 bandwidth.rate_hz);
            low_pass_[axis].settle(now[axis]);
            filtered_axes_[axis] = now[axis];
        } else {
            const double slope = (now[axis] - input_[axis]) / steps;
            for (int i = 1; i <= steps; ++i)
                filtered_axes_[axis] = low_pass_[axis].step(input_[axis] + slope * i);
        }
    }
    input_ = now;
    filtered_ = true;
}

void Mpu6000::fail(FaultKind kind, uint64_t now_us, double for_s) {
    failing_s_ = for_s;
    if (kind == fault_) return;
    if (kind == FaultKind::lost || fault_ == FaultKind::lost) powerOn(now_us, kRegistersStart_us);
    fault_ = kind;
}

void Mpu6000::power(bool on, uint64_t now_us) {
    powered_ = on;
    powerOn(now_us, kSlowStart_us);
}

// In steps of the registers: 4096 are 250 deg/s or 1 g as the firmware sets the ranges.
double Mpu6000::asFailing(double counts) {
    constexpr double kNoise = 6000, kFull = 32767;
    if (fault_ == FaultKind::noisy) return counts + kNoise * random_.normal();
    if (fault_ == FaultKind::nonsense) return kFull * (2 * random_.uniform() - 1);
    return counts;
}

// A gyro that is dead goes on saying what it said last.
void Mpu6000::measure(double throttle) {
    constexpr double kDrift_rads2 = 0.1 * kRadians;  // 3 deg/s in half a minute
    if (fault_ == FaultKind::stuck) return;
    const double accel_deviation =
        kGravity_mss * combined(errors_.accel_noise_g, errors_.accel_vibration_g * throttle);
    const double gyro_deviation =
        kRadians * combined(errors_.gyro_noise_dps, errors_.gyro_vibration_dps * throttle);
    const int accel_range = registers_[kAccelConfig] >> 3 & 3;
    const int gyro_range = registers_[kGyroConfig] >> 3 & 3;
    const double full_accel = isRevisionC(product_id_) ? 8192 : 16384;
    const double per_mss = full_accel / (1 << accel_range) / kGravity_mss;
    const double per_rads = 131.2 / (1 << gyro_range) / kRadians;  // 16.4 at 2000 deg/s
    for (int axis = 0; axis < kAxes; ++axis) {
        const bool accel = axis < 3;
        if (!accel && deadGyro(fault_) == axis - 3) continue;
        const bool drifts = !accel && fault_ == FaultKind::drift;
        const double drift = drifts ? kDrift_rads2 * failing_s_ : 0;
        const double value = filtered_axes_[axis] * scale_[axis] + bias_[axis] + drift +
                             (accel ? accel_deviation : gyro_deviation) * random_.normal();
        const int at = accel ? 2 * axis : 2 * axis + 2;
        putWord(&measured_[at], asFailing(value * (accel ? per_mss : per_rads)));
    }
    putWord(&measured_[6], (kTemperature_c - 36.53) * 340);
}

// The newest sample becomes what the registers show; during a burst that waits for its end.
void Mpu6000::publish() {
    waiting_ = false;
    if (unread_) ++count_.lost;
    unread_ = true;
    std::copy(measured_.begin(), measured_.end(), &registers_[kData]);
    registers_[kInterruptStatus] |= kDataReady;
    if (!(registers_[kInterruptEnable] & kDataReady)) return;
    pin_ = !(registers_[kInterruptPin] & kActiveLow);
    if (!(registers_[kInterruptPin] & kLatch)) pulse_end_us_ = last_sample_us_ + kPulse_us;
}

}  // namespace simulator
