// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/hmc5883l.hpp"

#include "core/rom.hpp"
#include "hal/i2c.hpp"

namespace drivers {
namespace {

constexpr uint8_t kAddress = 0x1E;
constexpr uint8_t kConfigA = 0, kData = 3, kIdentification = 10;

// Configuration A, B and mode: data sheet tables 3 to 11. Each has a transfer of its own, for the
// increment of the register is promised for reads alone. The self-test needs A and B once.
constexpr uint8_t kConfigB = 1, kMode = 2, kSettings = 3;
constexpr uint8_t kSelfTest[kSettings] ROM = {0x11, 0x60, 0x01};  // + bias field, 660 LSB/G, single
constexpr uint8_t kConfiguration = 0x78, kGain = 0x20;
constexpr uint8_t kMeasure[kSettings] ROM = {kConfiguration, kGain,
                                             0x00};  // mean of 8, 75 Hz, 1090 LSB/G
constexpr float kMilligaussPerCount = 1000.0f / 1090.0f;

// The HMC5843 has no averaging: those bits of configuration A stay 0. Its rate for the same bits is
// 50 Hz; the strap's field is 0.55 G on every axis, measured at the 1300 LSB/G of gain 0x20.
constexpr uint8_t kOldConfiguration = 0x18;
constexpr float kOldMilligaussPerCount = 1000.0f / 1300.0f;
constexpr float kOldExpected = 0.55f * 1300.0f;

// The task comes every 20 ms: it starts a read, fetches it, and lets one go by: 17 Hz of the 75
// measured, for five a second are used.
constexpr uint8_t kRead_ms = 25;
constexpr uint8_t kReadsPerVerify = 33;  // 2 s
constexpr uint8_t kExcite_ms = 50;
constexpr uint16_t kRetry_ms = 1000;
constexpr uint16_t kSilent_ms = 500;
constexpr int16_t kOverflow = -4096;

// The self-test strap's field is 1.16 G along x and y and 1.08 G along z, at 660 LSB/G.
constexpr float kExpected = 1.16f * 660.0f, kExpectedZ = 1.08f * 660.0f;
constexpr float kLeastScale = 0.7f, kMaxScale = 1.35f;
constexpr uint8_t kDroppedTries = 2, kGoodTries = 5, kMaxTries = 25;

struct Counts {
    int16_t axis[3];  // x, y, z of the chip
};

int16_t word(const uint8_t* bytes) {
    return static_cast<int16_t>(static_cast<uint16_t>(bytes[0]) << 8 | bytes[1]);
}
Counts counts(const uint8_t* bytes, bool old) {  // the chip sends x, z, y, the old one x, y, z
    const uint8_t y = old ? 2 : 4;
    return {{word(bytes), word(bytes + y), word(bytes + 6 - y)}};
}
float milligaussPerCount(bool old) { return old ? kOldMilligaussPerCount : kMilligaussPerCount; }
bool overflowed(const Counts& c) {
    return c.axis[0] == kOverflow || c.axis[1] == kOverflow || c.axis[2] == kOverflow;
}

}  // namespace

float Hmc5883l::scale(uint8_t axis) const { return scale_[axis] / milligaussPerCount(old_); }

bool Hmc5883l::step(uint32_t now_ms) {
    if (now_ms - good_ms_ > kSilent_ms) healthy_ = false;
    if (under_way_) {
        uint8_t bytes[hal::kI2cBytes];
        const core::Status status = hal::i2cResult(hal::I2cUser::compass, bytes, expected_bytes_);
        if (status == core::Status::busy) return false;
        under_way_ = false;
        if (status == core::Status::ok) {
            errors_in_a_row_ = 0;
            return finish(bytes, now_ms);
        }
        if (state_ != State::run || ++errors_in_a_row_ > 5) {
            fail(now_ms);
            return false;
        }
    }
    if (now_ms - since_ms_ >= wait_ms_) begin();
    return false;
}

void Hmc5883l::begin() {
    uint8_t out[2] = {kData};
    uint8_t out_size = 1;
    expected_bytes_ = 6;
    if (state_ == State::excite || state_ == State::configure) {
        out[0] = setting_;
        out[1] = core::romRead((state_ == State::excite ? kSelfTest : kMeasure)[setting_]);
        if (old_ && setting_ == kConfigB) out[1] = kGain;
        out_size = 2;
        expected_bytes_ = 0;
    } else if (state_ == State::probe) {
        out[0] = kConfigA;
        out[1] = kConfiguration;
        out_size = 2;
        expected_bytes_ = 0;
    } else if (state_ != State::excited && state_ != State::run) {
        out[0] = state_ == State::identify ? kIdentification : kConfigA;
        expected_bytes_ = 3;
    }
    under_way_ = hal::i2cStart(hal::I2cUser::compass, kAddress, out, out_size, expected_bytes_);
}

bool Hmc5883l::finish(const uint8_t* bytes, uint32_t now_ms) {
    switch (state_) {
        case State::identify:
            if (bytes[0] != 'H' || bytes[1] != '4' || bytes[2] != '3') {
                fail(now_ms);
                return false;
            }
            enter(State::probe, now_ms, 0);
            return false;
        case State::probe:
            enter(State::probed, now_ms, 0);
            return false;
        case State::probed:
            identifyChip(bytes[0], now_ms);
            return false;
        case State::excite:
            if (allSet(now_ms)) enter(State::excited, now_ms, kExcite_ms);
            return false;
        case State::excited:
            checkSelfTest(bytes, now_ms);
            return false;
        case State::configure:
            if (!allSet(now_ms)) return false;
            discard_ = 2;  // a new gain holds from the second measurement on
            reads_ = 0;
            good_ms_ = now_ms;
            enter(State::run, now_ms, kRead_ms);
            return false;
        case State::run:
            return takeField(bytes, now_ms);
        case State::verify:  // a chip that lost its supply for a moment stands in single mode
            if (bytes[0] != (old_ ? kOldConfiguration : kConfiguration) || bytes[1] != kGain ||
                (bytes[2] & 3) != 0) {
                fail(now_ms);
            } else {
                enter(State::run, now_ms, kRead_ms);
            }
            return false;
    }
    return false;
}

bool Hmc5883l::allSet(uint32_t now_ms) {
    if (setting_ == kMode) return true;
    ++setting_;
    enter(state_, now_ms, 0);
    return false;
}

void Hmc5883l::identifyChip(uint8_t configuration, uint32_t now_ms) {
    old_ = configuration == kOldConfiguration;
    if (!old_ && configuration != kConfiguration) return fail(now_ms);
    tries_ = good_tries_ = setting_ = 0;
    measured_[0] = measured_[1] = measured_[2] = 0;
    enter(State::excite, now_ms, 0);
}

float Hmc5883l::expectedOf(uint8_t axis) const {
    return old_ ? kOldExpected : (axis == 2 ? kExpectedZ : kExpected);
}

void Hmc5883l::checkSelfTest(const uint8_t* bytes, uint32_t now_ms) {
    Counts read = counts(bytes, old_);
    bool good = tries_ >= kDroppedTries && !overflowed(read);
    // the coil of some clones is wound the other way round
    if (read.axis[0] < 0)
        for (int16_t& axis : read.axis) axis = static_cast<int16_t>(-axis);
    for (uint8_t i = 0; good && i < 3; ++i) {
        const float expected = expectedOf(i), count = core::real(read.axis[i]);
        good = count * kMaxScale >= expected && count * kLeastScale <= expected;
    }
    if (good) {
        for (uint8_t i = 0; i < 3; ++i) measured_[i] += core::real(read.axis[i]);
        ++good_tries_;
    }
    if (good_tries_ == kGoodTries) {
        for (uint8_t i = 0; i < 3; ++i) {
            scale_[i] = expectedOf(i) * kGoodTries / measured_[i] * milligaussPerCount(old_);
        }
        setting_ = kConfigA;
        enter(State::configure, now_ms, 0);
    } else if (++tries_ >= kMaxTries) {
        fail(now_ms);
    } else {
        enter(State::excite, now_ms, 0);
    }
}

bool Hmc5883l::takeField(const uint8_t* bytes, uint32_t now_ms) {
    enter(++reads_ >= kReadsPerVerify ? State::verify : State::run, now_ms, kRead_ms);
    if (state_ == State::verify) reads_ = 0;
    const Counts read = counts(bytes, old_);
    if (overflowed(read)) {
        if (saturated_ != UINT16_MAX) ++saturated_;
        return false;
    }
    if (discard_ > 0) {
        --discard_;
        return false;
    }
    // All zeros is a chip that does not measure: the earth's field is nowhere below 200 mG.
    if (read.axis[0] == 0 && read.axis[1] == 0 && read.axis[2] == 0) return false;
    const int16_t sum = static_cast<int16_t>(read.axis[0] + read.axis[1] + read.axis[2]);
    sum_mg_ = static_cast<int16_t>(sum - (sum >> (old_ ? 2 : 4)));  // 0.77 and 0.92 mG a count
    float chip[3];
    for (uint8_t i = 0; i < 3; ++i) chip[i] = core::real(read.axis[i]) * scale_[i];
    // The chip lies on the board with its x to the left and its y to the rear, z up; the old one
    // with its x to the rear and its y to the right.
    field_mg_ = {-chip[1], -chip[0], -chip[2]};
    if (old_) field_mg_ = {-chip[0], chip[1], -chip[2]};
    good_ms_ = now_ms;
    healthy_ = true;
    return true;
}

void Hmc5883l::fail(uint32_t now_ms) {
    if (restarts_ != UINT16_MAX) ++restarts_;
    healthy_ = false;
    errors_in_a_row_ = 0;
    enter(State::identify, now_ms, kRetry_ms);
}

}  // namespace drivers
