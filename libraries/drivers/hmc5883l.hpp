// SPDX-License-Identifier: GPL-3.0-or-later
// Honeywell HMC5883L compass on I2C, or its predecessor HMC5843: found, identified, scaled by its
// own self-test field, then read at 50 Hz. The bus works by interrupts, so a step only starts a
// transfer or fetches the end of one.
#pragma once
#include <stdint.h>

#include "core/maths.hpp"

namespace drivers {

class Hmc5883l {
public:
    void start() { enter(State::identify, 0, 0); }
    // Every frame. True: a new field is there.
    bool step(uint32_t now_ms);

    core::Vector3 field_mg() const { return field_mg_; }  // milligauss, body axes
    // Of all axes, within 3 %, by the chip's counts alone: it stays while the chip repeats itself.
    int16_t sum_mg() const { return sum_mg_; }
    bool healthy() const { return healthy_; }
    uint16_t saturated() const { return saturated_; }  // samples in which an axis overflowed
    uint16_t restarts() const { return restarts_; }
    float scale(uint8_t axis) const;  // chip axes, from the self-test

private:
    enum class State : uint8_t { identify, probe, probed, excite, excited, configure, run, verify };

    void enter(State state, uint32_t now_ms, uint16_t wait_ms) {
        state_ = state;
        since_ms_ = now_ms;
        wait_ms_ = wait_ms;
    }
    void begin();
    bool finish(const uint8_t* bytes, uint32_t now_ms);
    bool allSet(uint32_t now_ms);
    void identifyChip(uint8_t configuration, uint32_t now_ms);
    float expectedOf(uint8_t axis) const;
    void checkSelfTest(const uint8_t* bytes, uint32_t now_ms);
    bool takeField(const uint8_t* bytes, uint32_t now_ms);
    void fail(uint32_t now_ms);

    core::Vector3 field_mg_ = {0, 0, 0};
    float scale_[3] = {};     // mG a count, by the self-test
    float measured_[3] = {};  // its sums
    uint32_t since_ms_ = 0;
    uint32_t good_ms_ = 0;
    int16_t sum_mg_ = 0;
    uint16_t wait_ms_ = 0;
    uint16_t saturated_ = 0;
    uint16_t restarts_ = 0;
    State state_ = State::identify;
    uint8_t tries_ = 0, good_tries_ = 0;  // of the self-test
    uint8_t reads_ = 0;                   // since the configuration was last verified
    uint8_t discard_ = 0;                 // fields still measured with another gain
    uint8_t setting_ = 0;                 // the configuration register that is written next
    uint8_t errors_in_a_row_ = 0;
    uint8_t expected_bytes_ = 0;
    bool under_way_ = false;
    bool healthy_ = false;
    bool old_ = false;  // an HMC5843
};

}  // namespace drivers
