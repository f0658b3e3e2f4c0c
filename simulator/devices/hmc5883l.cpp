// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/hmc5883l.hpp"

#include <algorithm>
#include <cmath>

namespace simulator {
namespace {

enum Register : uint8_t { kConfigA, kConfigB, kMode, kData, kStatus = 9, kIdentity = 10 };
constexpr int kRegisters = 13;
constexpr uint8_t kContinuous = 0, kSingle = 1, kIdle = 2;
constexpr uint8_t kReady = 1, kLock = 2;
constexpr uint64_t kSingle_us = 6000, kWriting_us = 250;
// Operating characteristics, turn-on time: for I2C commands and for the analogue circuit.
constexpr uint64_t kReady_us = 200, kSettled_us = 50'000;
constexpr uint8_t kWholeSet = 0x3F;

constexpr double kCountsPerGauss[8] = {1370, 1090, 820, 660, 440, 390, 330, 230};
constexpr double kRate_hz[8] = {0.75, 1.5, 3, 7.5, 15, 30, 75, 75};  // the last is reserved
constexpr double kBias_mg[3] = {1160, 1160, 1080};  // self-test field, chip x, y, z
constexpr int kDataOrder[3] = {0, 2, 1};            // chip x, z, y

// The HMC5843's.
constexpr double kOldCountsPerGauss[8] = {1620, 1300, 970, 780, 530, 460, 390, 280};
constexpr double kOldRate_hz[8] = {0.5, 1, 2, 5, 10, 20, 50, 50};
constexpr double kOldBias_mg = 550;
constexpr uint8_t kAveraging = 0x60;  // of configuration A, which it has not

// Of a vector along two axes, when the axes are turned from the first towards the second.
void turnAxes(double& first, double& second, double by_deg) {
    const double sine = std::sin(by_deg * M_PI / 180), cosine = std::cos(by_deg * M_PI / 180);
    const double along = first * cosine + second * sine;
    second = second * cosine - first * sine;
    first = along;
}

uint16_t asCounts(double value) {
    const double counts = std::round(value);
    const bool overflow = counts < -2048 || counts > 2047;
    return static_cast<uint16_t>(static_cast<int16_t>(overflow ? -4096 : counts));
}

}  // namespace

Hmc5883l::Hmc5883l(uint64_t seed, const SensorErrors& errors, CompassMount mount)
    : errors_(errors), mount_(mount), random_(seed, 3) {
    resetRegisters();
    for (double& offset : offset_mg_)
        offset = random_.uniform() < 0.5 ? -errors.compass_offset_mg : errors.compass_offset_mg;
}

void Hmc5883l::resetRegisters() {
    registers_ = {0x10, 0x20, kIdle};
    registers_[kIdentity] = 'H';
    registers_[kIdentity + 1] = '4';
    registers_[kIdentity + 2] = '3';
}

void Hmc5883l::power(bool on, uint64_t now_us) {
    powered_ = on;
    resetRegisters();
    pointer_ = read_mask_ = 0;
    pointer_next_ = false;
    measured_us_ = UINT64_MAX;
    ready_us_ = now_us + kReady_us;
    settled_us_ = now_us + kSettled_us;
}

bool Hmc5883l::start(bool read, uint64_t now_us) {
    advance(now_us);
    pointer_next_ = !read;
    return !silent() && now_us >= ready_us_;
}

bool Hmc5883l::write(uint8_t byte, uint64_t now_us) {
    if (silent()) return false;
    advance(now_us);
    if (pointer_next_) {
        pointer_ = byte;
        pointer_next_ = written_ = false;
    } else {
        writeRegister(byte, now_us);
    }
    return true;
}

uint8_t Hmc5883l::read(bool, uint64_t now_us) {
    if (silent()) return 0xFF;
    advance(now_us);
    return readRegister();
}

void Hmc5883l::stop(uint64_t) { pointer_next_ = false; }

// The register is promised to go up by itself for reads (900405, I2C interface protocol): here a
// second byte of a write goes nowhere.
void Hmc5883l::writeRegister(uint8_t value, uint64_t now_us) {
    const uint8_t at = pointer_;
    if (at > kMode || written_) return;
    written_ = true;
    registers_[at] = value;
    if (at == kConfigA && old()) registers_[at] &= static_cast<uint8_t>(~kAveraging);
    read_mask_ = 0;  // any write to a configuration register ends a lock
    registers_[kStatus] &= static_cast<uint8_t>(~kLock);
    if (at == kMode) begin(now_us);
}

uint8_t Hmc5883l::readRegister() {
    if (pointer_ >= kRegisters) return 0;
    const uint8_t at = pointer_, value = registers_[at];
    pointer_ = static_cast<uint8_t>(at == kStatus - 1 ? +kData : (at + 1) % kRegisters);
    if (at >= kData && at < kStatus) {
        read_mask_ = static_cast<uint8_t>(read_mask_ | 1 << (at - kData));
        const bool part = read_mask_ != kWholeSet;
        registers_[kStatus] =
            static_cast<uint8_t>((registers_[kStatus] & ~kLock) | (part ? kLock : 0));
        if (!part) read_mask_ = 0;
    }
    return value;
}

void Hmc5883l::begin(uint64_t now_us) {
    const uint8_t mode = registers_[kMode] & 3;
    registers_[kStatus] = 0;
    measured_us_ = mode == kContinuous ? now_us + period_us()
                   : mode == kSingle   ? now_us + kSingle_us
                                       : UINT64_MAX;
    if (measured_us_ != UINT64_MAX) measured_us_ = std::max(measured_us_, settled_us_);
}

uint64_t Hmc5883l::period_us() const {
    const double* const rates_hz = old() ? kOldRate_hz : kRate_hz;
    return static_cast<uint64_t>(1e6 / rates_hz[registers_[kConfigA] >> 2 & 7]);
}

void Hmc5883l::advance(uint64_t now_us) {
    if (now_us >= measured_us_) {
        measure();
        if ((registers_[kMode] & 3) == kContinuous) {
            measured_us_ += ((now_us - measured_us_) / period_us() + 1) * period_us();
        } else {
            registers_[kMode] = kIdle;
            measured_us_ = UINT64_MAX;
        }
    }
    // RDY falls while the data registers are being written.
    if (measured_us_ != UINT64_MAX && now_us + kWriting_us >= measured_us_)
        registers_[kStatus] &= static_cast<uint8_t>(~kReady);
}

void Hmc5883l::measure() {
    const auto field_mg = chipField_mg();
    const bool locked = registers_[kStatus] & kLock;
    if (!locked) {
        const double* const gains = old() ? kOldCountsPerGauss : kCountsPerGauss;
        const double gain = gains[registers_[kConfigB] >> 5] / 1000;
        for (int i = 0; i < 3; ++i) {
            const uint16_t counts = asCounts(field_mg[old() ? i : kDataOrder[i]] * gain);
            registers_[kData + 2 * i] = static_cast<uint8_t>(counts >> 8);
            registers_[kData + 2 * i + 1] = static_cast<uint8_t>(counts);
        }
    }
    registers_[kStatus] |= kReady;
}

void Hmc5883l::fail(FaultKind kind, double for_s) {
    for (FaultyValue& fault : faults_) fault.fail(kind, for_s);
    unplug(kind == FaultKind::lost);
}

std::array<double, 3> Hmc5883l::chipAxes() const {
    std::array<double, 3> body;
    for (size_t i = 0; i < 3; ++i) body[i] = body_mg_[i] + offset_mg_[i];
    if (faults_[0].kind() == FaultKind::jump) body = {-body[1], body[0], body[2]};
    turnAxes(body[0], body[1], mount_.yaw_deg);
    turnAxes(body[2], body[0], mount_.pitch_deg);
    turnAxes(body[1], body[2], mount_.roll_deg);
    if (old()) return {-body[0], body[1], -body[2]};
    return {-body[1], -body[0], -body[2]};
}

// In self-test the outside field cancels (set and reset pulses), the coil's is left.
std::array<double, 3> Hmc5883l::chipField_mg() {
    std::array<double, 3> chip = chipAxes();
    const int test = registers_[kConfigA] & 3;
    for (int i = 0; i < 3; ++i) {
        const double coil_mg = old() ? kOldBias_mg : kBias_mg[i];
        const double bias_mg = mount_.inverted_self_test ? -coil_mg : coil_mg;
        if (test == 1) chip[i] = bias_mg;
        if (test == 2) chip[i] = -bias_mg;
        chip[i] += errors_.compass_noise_mg * random_.normal();
        if (test == 0) chip[i] = faults_[i].of(chip[i], {250, -900, 900, 0, 5}, random_);
    }
    return chip;
}

}  // namespace simulator
