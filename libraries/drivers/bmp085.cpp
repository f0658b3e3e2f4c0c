// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/bmp085.hpp"

#include "hal/i2c.hpp"

namespace drivers {
namespace {

constexpr uint8_t kAddress = 0x77;
constexpr uint8_t kIdentity = 0xD0, kEeprom = 0xAA, kControl = 0xF4, kResult = 0xF6;
constexpr uint8_t kIsBmp085 = 0x55;
constexpr uint8_t kTemperature = 0x2E, kPressure = 0x34;

// Two samples a reading (5 Pa of noise): the longest mode that is over before the next frame. With
// eight (3 Pa) there were a third as many readings.
constexpr uint8_t kOversampling = 1;
// The longest the data sheet has, 4.5 and 7.5 ms, and a transfer at 100 kHz before it.
constexpr uint16_t kTemperature_us = 5000, kPressure_us = 8000;
constexpr uint8_t kPressuresPerTemperature = 4;
constexpr uint32_t kRetry_us = 250000, kSilent_us = 200000;

constexpr uint8_t kPartWords = hal::kI2cBytes / 2;
constexpr uint8_t kParts = (Bmp085Compensation::kWords + kPartWords - 1) / kPartWords;

uint16_t word(const uint8_t* bytes) {
    return static_cast<uint16_t>(static_cast<uint16_t>(bytes[0]) << 8 | bytes[1]);
}
// The words have no check, and one that was read wrong would last: all are read twice.
uint8_t partOf(uint8_t phase) { return phase < kParts ? phase : phase - kParts; }
uint8_t partWords(uint8_t part) {
    const uint8_t left = static_cast<uint8_t>(Bmp085Compensation::kWords - part * kPartWords);
    return left < kPartWords ? left : kPartWords;
}

}  // namespace

bool Bmp085::step(uint32_t now_us) {
    if (now_us - good_us_ > kSilent_us) healthy_ = false;
    bool fresh = false;
    if (under_way_) {
        uint8_t bytes[hal::kI2cBytes];
        const core::Status status = hal::i2cResult(hal::I2cUser::barometer, bytes, expected_bytes_);
        if (status == core::Status::busy) return false;
        under_way_ = false;
        if (status == core::Status::ok) {
            fresh = finish(bytes, now_us);
        } else {
            bad(now_us);
        }
    }
    if (now_us - since_us_ >= wait_us_) begin(now_us);
    return fresh;
}

void Bmp085::begin(uint32_t now_us) {
    uint8_t out[2] = {kIdentity};
    uint8_t out_size = 1;
    expected_bytes_ = 1;
    if (state_ == State::load) {
        const uint8_t part = partOf(phase_);
        out[0] = static_cast<uint8_t>(kEeprom + part * hal::kI2cBytes);
        expected_bytes_ = static_cast<uint8_t>(2 * partWords(part));
    } else if (state_ == State::convert) {
        out[0] = kControl;
        out[1] = phase_ == 0 ? kTemperature : kPressure + (kOversampling << 6);
        out_size = 2;
        expected_bytes_ = 0;
    } else if (state_ == State::read) {
        out[0] = kResult;
        expected_bytes_ = phase_ == 0 ? 2 : 3;
    }
    under_way_ = hal::i2cStart(hal::I2cUser::barometer, kAddress, out, out_size, expected_bytes_);
    if (under_way_ && state_ == State::convert) since_us_ = now_us;
}

bool Bmp085::finish(const uint8_t* bytes, uint32_t now_us) {
    switch (state_) {
        case State::identify:
            if (bytes[0] != kIsBmp085) {
                fail(now_us);
                return false;
            }
            phase_ = 0;
            wait_us_ = 0;
            state_ = State::load;
            return false;
        case State::load:
            takeWords(bytes, now_us);
            return false;
        case State::convert:
            wait_us_ = phase_ == 0 ? kTemperature_us : kPressure_us;
            state_ = State::read;
            return false;
        case State::read:
            return use(bytes, now_us);
    }
    return false;
}

void Bmp085::takeWords(const uint8_t* bytes, uint32_t now_us) {
    const uint8_t part = partOf(phase_);
    for (uint8_t i = 0; i < partWords(part); ++i) {
        uint16_t& to = words_[part * kPartWords + i];
        const uint16_t from = word(bytes + 2 * i);
        if (part != phase_ && from != to) return fail(now_us);
        to = from;
    }
    if (++phase_ < 2 * kParts) return;
    phase_ = 0;
    if (!compensation_.load(words_)) return fail(now_us);
    good_us_ = now_us;
    bad_in_a_row_ = 0;
    state_ = State::convert;
}

// Limits: the data sheet's ranges of operation, 300..1100 hPa and -40..85 C.
bool Bmp085::use(const uint8_t* bytes, uint32_t now_us) {
    wait_us_ = 0;
    state_ = State::convert;
    if (phase_ == 0) {
        compensation_.temperature(word(bytes));
        // A temperature that can not be is asked for again: pressures need it.
        if (good(compensation_.temperature_dc(), -400, 850, now_us)) phase_ = 1;
        return false;
    }
    phase_ = phase_ < kPressuresPerTemperature ? phase_ + 1 : 0;
    const uint32_t raw =
        (static_cast<uint32_t>(word(bytes)) << 8 | bytes[2]) >> (8 - kOversampling);
    const int32_t pressure_pa = compensation_.pressure_pa(raw, kOversampling);
    if (!good(pressure_pa, 30000, 110000, now_us)) return false;
    pressure_pa_ = pressure_pa;
    good_us_ = now_us;
    healthy_ = true;
    return true;
}

bool Bmp085::good(int32_t value, int32_t least, int32_t most, uint32_t now_us) {
    if (value >= least && value <= most) {
        bad_in_a_row_ = 0;
        return true;
    }
    bad(now_us);
    return false;
}

// In flight one transfer in disorder is not worth the second that starting again takes.
void Bmp085::bad(uint32_t now_us) {
    if (bad_reads_ != UINT16_MAX) ++bad_reads_;
    if (state_ < State::convert || ++bad_in_a_row_ > 20) return fail(now_us);
    wait_us_ = 0;
    state_ = State::convert;
}

void Bmp085::fail(uint32_t now_us) {
    if (restarts_ != UINT16_MAX) ++restarts_;
    healthy_ = false;
    bad_in_a_row_ = 0;
    state_ = State::identify;
    since_us_ = now_us;
    wait_us_ = kRetry_us;
}

}  // namespace drivers
