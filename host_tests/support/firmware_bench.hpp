// SPDX-License-Identifier: GPL-3.0-or-later
// The flight program on the doubles, brought into a known state before each test.
#pragma once
#include <gtest/gtest.h>
#include <string.h>

#include <string>
#include <vector>

#include "fakes/fakes.hpp"
#include "firmware/control/attitude_control.hpp"
#include "firmware/gcs/telemetry.hpp"
#include "firmware/modes/mode_switch.hpp"
#include "firmware/modes/modes.hpp"
#include "firmware/notify/text_queue.hpp"
#include "firmware/safety/failsafe.hpp"
#include "firmware/sensors/radio.hpp"
#include "firmware/sensors/rc_override.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace bench {

inline const std::vector<uint16_t> kCentred = {1500, 1500, 1100, 1500, 1500, 1500, 1500, 1815};

// What has been sent since, as "severity text".
inline std::vector<std::string> statusTexts() {
    std::vector<std::string> texts;
    using namespace firmware::notify;
    char text[kTextSize];
    Severity severity;
    while (readText(0, severity, text)) {
        texts.push_back(std::to_string(static_cast<int>(severity)) + ' ' +
                        std::string(text, strnlen(text, sizeof text)));
        for (uint8_t reader : {0, 1, 2})
            if (textWaits(reader)) textTaken(reader);
    }
    return texts;
}

class Bench : public testing::Test {
protected:
    void SetUp() override {
        fakes::reset();
        while (firmware::state::parametersLoad() != core::Status::ok) fakes::advance_ms(10);
        settle(kCentred);
        firmware::modes::requestMode(firmware::state::Mode::manual,
                                     firmware::modes::ModeReason::boot);
    }

    // What attitude control takes of parameters and airspeed; no time passes here.
    static void prepareControl() {
        firmware::control::runSpeedScaling();
        firmware::control::runRollGains();
        firmware::control::runPitchGains();
        firmware::control::runControlLimits();
    }

    // Frames from the receiver for a quarter of a second, the sticks at the given pulses.
    void settle(const std::vector<uint16_t>& sticks) {
        for (int i = 0; i < 25; ++i) {
            if (i % 2 == 0) fakes::receiveRc(sticks);
            firmware::sensors::runRadio();
            if (i % 10 == 9) firmware::modes::runModeSwitch();
            fakes::advance_ms(10);
        }
    }
    static std::vector<uint16_t> with(int channel, uint16_t pulse_us) {
        std::vector<uint16_t> sticks = kCentred;
        sticks[channel - 1] = pulse_us;
        return sticks;
    }
    void loseRadio(uint32_t for_ms) {
        for (uint32_t ms = 0; ms < for_ms; ms += 10) {
            firmware::sensors::runRadio();
            if (ms % 100 == 0) firmware::safety::runFailsafe();
            fakes::advance_ms(10);
        }
    }
    // In the air with everything a flight needs.
    void fly(firmware::state::Mode mode) {
        using firmware::state::mutable_vehicle;
        mutable_vehicle.armed = true;
        mutable_vehicle.imu.healthy = mutable_vehicle.baro.healthy =
            mutable_vehicle.compass.healthy = true;
        mutable_vehicle.gps.healthy = mutable_vehicle.attitude.aligned = true;
        mutable_vehicle.estimate.flying = mutable_vehicle.estimate.known =
            mutable_vehicle.home.set = true;
        mutable_vehicle.estimate.height_m = 80;
        firmware::modes::requestMode(mode, firmware::modes::ModeReason::ground);
        ASSERT_EQ(mutable_vehicle.mode, mode);
    }
};

}  // namespace bench
