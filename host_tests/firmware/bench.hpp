// SPDX-License-Identifier: GPL-3.0-or-later
// The flight program on the doubles, brought into a known state before each test.
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "fakes/fakes.hpp"
#include "firmware/failsafe/failsafe.hpp"
#include "firmware/modes.hpp"
#include "firmware/parameters.hpp"
#include "firmware/radio.hpp"
#include "firmware/telemetry/telemetry.hpp"
#include "firmware/vehicle.hpp"

namespace bench {

inline const std::vector<uint16_t> kCentred = {1500, 1500, 1100, 1500, 1500, 1500, 1500, 1815};

class Bench : public testing::Test {
protected:
    void SetUp() override {
        fakes::reset();
        while (firmware::parametersLoad() != core::Status::ok) fakes::advance_ms(10);
        firmware::rcOverrideRelease();
        settle(kCentred);
        firmware::vehicle.armed = false;
        for (int i = 0; i < 3; ++i) firmware::runFailsafe();
        const firmware::Mode none = firmware::Mode::initialising;
        firmware::vehicle = {};
        firmware::vehicle.mode = none;
        settle(kCentred);
        // through STABILIZE, so that MANUAL is entered anew whatever came before
        firmware::setMode(firmware::Mode::stabilize, firmware::ModeReason::boot);
        firmware::setMode(firmware::Mode::manual, firmware::ModeReason::boot);
    }

    // Frames from the receiver for a quarter of a second, the sticks where they are told to be.
    void settle(const std::vector<uint16_t>& sticks) {
        for (int i = 0; i < 25; ++i) {
            if (i % 2 == 0) fakes::receiveRc(sticks);
            firmware::runRadio();
            if (i % 10 == 9) firmware::runModeSwitch();
            fakes::advance_ms(10);
        }
    }
    std::vector<uint16_t> with(int channel, uint16_t pulse_us) {
        std::vector<uint16_t> sticks = kCentred;
        sticks[channel - 1] = pulse_us;
        return sticks;
    }
    void loseRadio(uint32_t for_ms) {
        for (uint32_t ms = 0; ms < for_ms; ms += 10) {
            firmware::runRadio();
            if (ms % 100 == 0) firmware::runFailsafe();
            fakes::advance_ms(10);
        }
    }
    // In the air with everything a flight needs.
    void fly(firmware::Mode mode) {
        auto& vehicle = firmware::vehicle;
        vehicle.armed = true;
        vehicle.imu.healthy = vehicle.baro.healthy = vehicle.compass.healthy = true;
        vehicle.gps.healthy = vehicle.attitude.aligned = true;
        vehicle.estimate.flying = vehicle.estimate.known = vehicle.home.set = true;
        vehicle.estimate.height_m = 80;
        firmware::setMode(mode, firmware::ModeReason::ground);
        ASSERT_EQ(vehicle.mode, mode);
    }
};

}  // namespace bench
