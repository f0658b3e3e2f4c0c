// SPDX-License-Identifier: GPL-3.0-or-later
// InvenSense MPU-6000 on SPI: brought up by a state machine that never waits, read once for every
// data-ready interrupt, summed there and averaged over whatever time passes between two take()s.
#pragma once
#include <stdint.h>

#include "core/fixed.hpp"
#include "core/maths.hpp"
#include "core/rom.hpp"
#include "drivers/imu_sample.hpp"
#include "hal/interrupts.hpp"

namespace drivers {

template <class Bus, class Select>
class Mpu6000 {
public:
    static constexpr uint16_t kPeriod_us = 5000;  // 200 Hz

    static constexpr float kRange_g = 8;  // of the accelerometers

    void start() {
        Select::output();
        Select::high();
        enter(State::reset, 0);
    }
    // After start(), when only the processor was reset: goes on at once with a chip that is up,
    // which takes 2 ms of writing its registers again.
    void resume();
    // Every frame. Brings the chip up, and up again when it falls silent or talks nonsense.
    void step(uint32_t now_ms);

    // From the data-ready interrupt, interrupts off: reads one sample and adds it up.
    void onDataReady();

    // The mean since the last take; false when no sample came.
    bool take(ImuSample& sample);
    bool take(ImuSums& sums);
    // From an interrupt: how far the airplane has turned since the last take(), and in how many
    // periods; for peeked(), which makes radians of it, the gyros' zero still in them.
    uint8_t peek(int16_t (&turned)[3]) const;
    static core::Vector3 peeked(const int16_t (&turned)[3]);
    uint8_t waiting() const { return sums_.count + sums_.dead; }  // samples since the last take

    bool healthy() const { return healthy_; }
    uint16_t badReads() const {
        const hal::Locked locked;
        return bad_reads_;
    }
    uint16_t restarts() const { return restarts_; }

private:
    enum class State : uint8_t { reset, settle, configure, run };
    struct Setting {
        uint8_t address, value;
    };
    static constexpr uint8_t kAccel = 0, kTemperature = 3, kGyro = 4, kWords = 7;
    struct Sums {
        int32_t chip[kWords];  // in the chip's order and axes
        uint8_t count, dead;   // samples summed; interrupts that found no chip
    };

    static const Setting kSettings[];

    static constexpr uint8_t kRead = 0x80;
    static constexpr uint8_t kProductId = 0x0C, kAccelConfig = 0x1C, kIntStatus = 0x3A,
                             kPowerManagement1 = 0x6B, kWhoAmI = 0x75;
    static constexpr uint8_t kDataReady = 0x01;
    static constexpr uint8_t kAwake = 0x03;
    static constexpr int8_t kPeekSteps = 8;  // 1.4 rad in 16 bits
    static constexpr uint8_t kLastSetting = 9;
    static constexpr uint8_t kMaxTries = 5;  // 5 ms apart: some chips wake up only after the first

    void enter(State state, uint32_t now_ms) {
        state_ = state;
        since_ms_ = now_ms;
    }
    void fail(uint32_t now_ms) {
        ++restarts_;
        healthy_ = false;
        enter(State::reset, now_ms);
    }
    int32_t takeSum(uint8_t word) {
        const int32_t sum = sums_.chip[word];
        sums_.chip[word] = 0;
        return sum;
    }
    void configureNext(uint32_t now_ms);
    void watch(uint32_t now_ms);
    static void writeRegister(uint8_t address, uint8_t value);
    static uint8_t readRegister(uint8_t address);
    static uint8_t accelRange();
    void refuse(bool dead);

    // Shared with the interrupt.
    Sums sums_ = {};
    uint16_t bad_reads_ = 0;
    volatile uint8_t beat_ = 0;  // goes on with every good sample
    volatile uint8_t bad_in_a_row_ = 0;
    volatile State state_ = State::reset;

    uint32_t since_ms_ = 0;
    uint8_t setting_ = 0;
    uint8_t tries_ = 0;  // of this setting
    uint8_t seen_ = 0;   // beat_ at the last step
    bool healthy_ = false;
    uint16_t restarts_ = 0;
};

// Register map RM-MPU-6000A. 42 Hz low-pass: at 200 samples a second 98 Hz would let a propeller's
// 100..180 Hz fold down into the band that is flown; the 2 ms it would save are a tenth of a
// servo's lag.
// clang-format off
template <class Bus, class Select>
const typename Mpu6000<Bus, Select>::Setting Mpu6000<Bus, Select>::kSettings[] ROM = {
    {kPowerManagement1, kAwake},  // awake, clock from the Z gyro
    {0x6C, 0x00},               // every axis on
    {0x6A, 0x10},               // no I2C
    {0x1A, 0x03},               // low-pass 42 Hz, base rate 1 kHz
    {0x19, 0x04},               // 1 kHz / 5 = 200 Hz
    {0x1B, 0x18},               // +-2000 deg/s
    {kAccelConfig, 0},          // +-8 g, see accelRange()
    {0x37, 0x30},               // interrupt pin held until any read
    {0x38, 0x01},               // interrupt: data ready
};
// clang-format on

template <class Bus, class Select>
void Mpu6000<Bus, Select>::writeRegister(uint8_t address, uint8_t value) {
    const typename Bus::Lock lock;
    Bus::slow();
    Select::low();
    Bus::transfer(address);
    Bus::transfer(value);
    Select::high();
    Bus::fast();
}

template <class Bus, class Select>
uint8_t Mpu6000<Bus, Select>::readRegister(uint8_t address) {
    const typename Bus::Lock lock;
    Bus::slow();
    Select::low();
    Bus::transfer(address | kRead);
    const uint8_t value = Bus::transfer(0);
    Select::high();
    Bus::fast();
    return value;
}

// Silicon revision C (these product numbers) has half the sensitivity at each setting.
template <class Bus, class Select>
uint8_t Mpu6000<Bus, Select>::accelRange() {
    const uint8_t product = readRegister(kProductId);
    const bool revision_c =
        product == 0x14 || product == 0x15 || product == 0x54 || product == 0x55;
    return revision_c ? 0x08 : 0x10;
}

template <class Bus, class Select>
void Mpu6000<Bus, Select>::step(uint32_t now_ms) {
    const uint32_t waited_ms = now_ms - since_ms_;
    switch (state_) {
        case State::reset:
            writeRegister(kPowerManagement1, 0x80);
            enter(State::settle, now_ms);
            break;
        case State::settle:
            if (waited_ms < 100) break;
            if (readRegister(kWhoAmI) != 0x68) return fail(now_ms);
            setting_ = tries_ = 0;
            enter(State::configure, now_ms - 5);
            break;
        case State::configure:
            if (waited_ms >= 5) configureNext(now_ms);
            break;
        case State::run:
            watch(now_ms);
            break;
    }
}

// One register a step, read back: the bus is slow here and a frame has other things to do.
template <class Bus, class Select>
void Mpu6000<Bus, Select>::configureNext(uint32_t now_ms) {
    if (setting_ == kLastSetting) {
        bad_in_a_row_ = 0;
        enter(State::run, now_ms);
        readRegister(kIntStatus);  // lets go of an interrupt from before anyone listened
        return;
    }
    const Setting setting = core::romRead(kSettings[setting_]);
    const uint8_t value = setting.address == kAccelConfig ? accelRange() : setting.value;
    writeRegister(setting.address, value);
    since_ms_ = now_ms;
    if (readRegister(setting.address) == value) {
        ++setting_;
        tries_ = 0;
    } else if (++tries_ == kMaxTries) {
        fail(now_ms);
    }
}

template <class Bus, class Select>
void Mpu6000<Bus, Select>::resume() {
    if (readRegister(kWhoAmI) != 0x68 || readRegister(kPowerManagement1) != kAwake) return;
    setting_ = tries_ = 0;
    enter(State::configure, 0);
    while (state_ == State::configure) configureNext(0);
}

template <class Bus, class Select>
void Mpu6000<Bus, Select>::watch(uint32_t now_ms) {
    if (bad_in_a_row_ > 4) return fail(now_ms);
    const uint8_t beat = beat_;
    if (beat != seen_) {
        seen_ = beat;
        since_ms_ = now_ms;
        healthy_ = true;
        return;
    }
    const uint32_t silent_ms = now_ms - since_ms_;
    if (silent_ms > 50) return fail(now_ms);
    // The pin is held until a read: an edge once missed would be the last one.
    if (silent_ms > 20) readRegister(kIntStatus);
}

// The longest stretch with interrupts off: every byte is added up while the next is on its way.
// The one begun last is read for nobody.
template <class Bus, class Select>
void Mpu6000<Bus, Select>::onDataReady() {
    if (state_ != State::run) return;
    Select::low();
    Bus::begin(kIntStatus | kRead);
    Bus::end();
    Bus::begin(0);
    const uint8_t full = sums_.count + sums_.dead;
    const uint8_t status = Bus::end();
    if (!(status & kDataReady) || status == 0xFF || full == 255) {
        Select::high();
        return refuse(status == 0 || status == 0xFF);
    }
    Bus::begin(0);
    int32_t* const last = sums_.chip + kWords;
    for (int32_t* sum = sums_.chip; sum != last; ++sum) {
        union {
            uint8_t bytes[2];  // the chip sends the high one first; this processor keeps it last
            int16_t value;
        } word;
        word.bytes[1] = Bus::end();
        Bus::begin(0);
        const int32_t so_far = *sum;
        word.bytes[0] = Bus::end();
        Bus::begin(0);
        *sum = so_far + word.value;
    }
    ++sums_.count;
    ++beat_;
    bad_in_a_row_ = 0;
    Bus::end();
    Select::high();
}

// A bus without a chip reads all zeros or all ones; without the data-ready bit the sample is one
// that was read before. When nobody has taken anything for a second, what there is, is kept.
template <class Bus, class Select>
void Mpu6000<Bus, Select>::refuse(bool dead) {
    if (sums_.count + sums_.dead == 255) return;
    if (dead) ++sums_.dead;
    ++bad_reads_;
    ++bad_in_a_row_;
}

template <class Bus, class Select>
bool Mpu6000<Bus, Select>::take(ImuSums& to) {
    const hal::Locked locked;
    to.count = sums_.count;
    to.periods = waiting();
    // On this board body x is the chip's y, body y its x, body z its -z.
    to.rate[0] = takeSum(kGyro + 1);
    to.rate[1] = takeSum(kGyro);
    to.rate[2] = -takeSum(kGyro + 2);
    to.force[0] = takeSum(kAccel + 1);
    to.force[1] = takeSum(kAccel);
    to.force[2] = -takeSum(kAccel + 2);
    takeSum(kTemperature);
    sums_.count = sums_.dead = 0;
    return to.count != 0;
}

template <class Bus, class Select>
uint8_t Mpu6000<Bus, Select>::peek(int16_t (&turned)[3]) const {
    for (uint8_t i = 0; i < 3; ++i) turned[i] = core::narrowed(sums_.chip[kGyro + i] / kPeekSteps);
    return waiting();
}

template <class Bus, class Select>
core::Vector3 Mpu6000<Bus, Select>::peeked(const int16_t (&turned)[3]) {
    constexpr float kStep = kRateStep_rads * kPeriod_us * 1e-6f * kPeekSteps;
    return core::Vector3{static_cast<float>(turned[1]), static_cast<float>(turned[0]),
                         -static_cast<float>(turned[2])} *
           kStep;
}

template <class Bus, class Select>
bool Mpu6000<Bus, Select>::take(ImuSample& sample) {
    ImuSums sums;
    if (!take(sums)) return false;
    const float rate = kRateStep_rads / sums.count, force = kForceStep_mss / sums.count;
    sample.rate_rads = {rate * sums.rate[0], rate * sums.rate[1], rate * sums.rate[2]};
    sample.force_mss = {force * sums.force[0], force * sums.force[1], force * sums.force[2]};
    sample.count = sums.count;
    sample.periods = sums.periods;
    return true;
}

}  // namespace drivers
