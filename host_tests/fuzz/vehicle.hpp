// SPDX-License-Identifier: GPL-3.0-or-later
// The whole flight program on the doubles, as the fuzzers drive it.
#pragma once
#include <stdlib.h>

#include <memory>

#include "fakes/fakes.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/gcs/telemetry.hpp"
#include "firmware/mission/mission.hpp"
#include "firmware/modes/modes.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"
#include "host_tests/support/fakes/vehicle.hpp"
#include "mavlink/peer.hpp"

namespace fuzz {

inline void require(bool holds) {
    if (!holds) abort();
}

inline fakes::Serial& line(uint8_t link) {
    return fakes::serial(link == 0 ? hal::Port::link0 : hal::Port::link1);
}

// As after power-on with a blank EEPROM.
inline void start() {
    fakes::reset();
    line(0).room = line(1).room = 127;
    while (firmware::state::parametersLoad() == core::Status::busy) fakes::advance_ms(10);
    firmware::gcs::telemetryStart();
    firmware::mission::missionBoot();
    firmware::state::mutable_vehicle.mode = firmware::state::Mode::initialising;
    firmware::modes::requestMode(firmware::state::Mode::manual, firmware::modes::ModeReason::boot);
}

// Parameters and state as after power-on, what is stored and under way as it was: a tenth of the
// cost. Now and then all is made new.
inline void calm() {
    static uint32_t starts = 0;
    static firmware::state::Parameters fresh;
    if (starts++ % 500 == 0) {
        start();
        fresh = firmware::state::parameters;
        return;
    }
    firmware::state::mutable_vehicle = {};
    firmware::state::parameters = fresh;
    for (uint8_t link = 0; link < firmware::state::kLinks; ++link) {
        line(link).in.clear();
        line(link).room = 127;
    }
}

// What the link's frame rests are like: two frames, and the background work of both.
inline void turn() {
    firmware::gcs::telemetrySend();
    for (int i = 0; i < 12 && firmware::gcs::telemetryPump(); ++i) {
    }
    firmware::mission::missionRun();
    firmware::state::parametersRun();
    fakes::advance_ms(20);
}

// Whatever was asked, only whole good frames of messages that exist are answered.
inline void checkAnswers() {
    for (uint8_t link = 0; link < firmware::state::kLinks; ++link) {
        static mavlink::PeerParser parser;
        size_t left = 0;
        for (const uint8_t byte : line(link).out) {
            ++left;
            for (bool whole = parser.put(byte); whole; whole = parser.next()) left = 0;
        }
        require(left == 0);
        require(parser.rejected() == 0);
        line(link).out.clear();
    }
}

// The bits of `how`: what the vehicle is doing.
inline void pose(uint8_t how) {
    auto& mutable_vehicle = firmware::state::mutable_vehicle;
    mutable_vehicle.armed = how & 1;
    mutable_vehicle.estimate.flying = how & 2;
    mutable_vehicle.home.set = mutable_vehicle.estimate.known = how & 4;
    mutable_vehicle.gps.fix =
        how & 4 ? firmware::state::GpsFix::three_d : firmware::state::GpsFix::none;
}

}  // namespace fuzz
