// SPDX-License-Identifier: GPL-3.0-or-later
// A flight that its records remember, and the start of a run after it.
#pragma once
#include <string.h>

#include <string>
#include <vector>

#include "firmware/notify/text_queue.hpp"
#include "firmware/safety/restart.hpp"
#include "firmware/safety/restart_records.hpp"
#include "firmware/safety/saved_home.hpp"
#include "firmware_bench.hpp"
#include "hal/clock.hpp"
#include "host_tests/support/fakes/vehicle.hpp"
#include "storage/owner.hpp"

namespace bench {

using namespace firmware;
using namespace firmware::notify;
using namespace firmware::state;
using namespace firmware::sensors;
using namespace firmware::modes;
using namespace firmware::safety;
using hal::ResetCause;

constexpr geo::Position kHome = {473977000, 85456000};

// In the air, armed, in FBWA; STABILIZE at the switch's first position.
class RestartBench : public Bench {
protected:
    void SetUp() override {
        Bench::SetUp();
        while (storage::claim() == core::Status::busy) fakes::advance_ms(10);
        begin(ResetCause::asked);  // a run before this flight
        parameters.switch_mode[0] = static_cast<int8_t>(Mode::stabilize);
        requestMode(Mode::fbwa, ModeReason::boot);
        mutable_vehicle.attitude.aligned = true;
        mutable_vehicle.armed = true;
        mutable_vehicle.estimate.flying = true;
        mutable_vehicle.estimate.ground_speed_mps = 14;
        mutable_vehicle.estimate.height_m = 40;
        mutable_vehicle.home = {kHome, 48800, true, false, 0};
        mutable_vehicle.baro.ground_pressure_pa = 95600;
        mutable_vehicle.baro.ground_temperature_c = 12;
        keep();
    }
    static void keep() {
        for (int i = 0; i < 2; ++i) runRestart();  // one of them writes
        runRestartSlowly();
    }
    // As start() goes through it, with memory as it was.
    static void begin(ResetCause cause) {
        fakes::watchdog().last_run = {cause, 3, static_cast<uint16_t>(hal::now_ms()), 80};
        fakes::resetClock();
        mutable_vehicle = {};
        mutable_vehicle.mode = Mode::initialising;
        restartBegin();
        restartResume();
        mutable_vehicle.attitude.aligned = true;
    }
    // One frame of the receiver, every 20 ms.
    static void receiveSwitch(uint16_t pulse_us) {
        fakes::receiveRc(with(8, pulse_us));
        runRadio();
        fakes::advance_ms(10);
        runRadio();
        runRestart();
        fakes::advance_ms(10);
    }
    static void lookAtSwitch(uint16_t pulse_us) {
        for (int i = 0; i < 5; ++i) receiveSwitch(pulse_us);
    }
};

inline void barometerReads(float above_zero_m) {
    mutable_vehicle.baro.healthy = true;
    mutable_vehicle.estimate.baro_height_m = above_zero_m;
}

inline void runUntil_ms(uint32_t end_ms) {
    for (; hal::now_ms() < end_ms; fakes::advance_ms(10)) runRestart();
}

}  // namespace bench
