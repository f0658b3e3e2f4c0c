// SPDX-License-Identifier: GPL-3.0-or-later
// The whole flight program on the doubles, as the fuzzers drive it.
#pragma once
#include <stdlib.h>

#include <memory>

#include "fakes/fakes.hpp"
#include "firmware/mission/mission.hpp"
#include "firmware/modes.hpp"
#include "firmware/parameters.hpp"
#include "firmware/telemetry/link.hpp"
#include "firmware/telemetry/telemetry.hpp"
#include "firmware/vehicle.hpp"
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
    firmware::vehicle = {};
    while (firmware::parametersLoad() == core::Status::busy) fakes::advance_ms(10);
    firmware::telemetryStart();
    firmware::missionBoot();
    firmware::vehicle.mode = firmware::Mode::initialising;
    firmware::setMode(firmware::Mode::manual, firmware::ModeReason::boot);
}

// Parameters and state as after power-on, what is stored and under way as it was: a tenth of the
// cost. Now and then all is made new.
inline void calm() {
    static uint32_t starts = 0;
    static firmware::Parameters fresh;
    if (starts++ % 500 == 0) {
        start();
        fresh = firmware::parameters;
        return;
    }
    firmware::vehicle = {};
    firmware::parameters = fresh;
    for (uint8_t link = 0; link < firmware::kLinks; ++link) {
        line(link).in.clear();
        line(link).room = 127;
    }
}

// What the link's frame rests are like: two frames, and the background work of both.
inline void turn() {
    firmware::telemetrySend();
    for (int i = 0; i < 12 && firmware::telemetryPump(); ++i) {
    }
    firmware::missionRun();
    firmware::parametersRun();
    fakes::advance_ms(20);
}

// Whatever was asked, only whole good frames of messages that exist are answered.
inline void checkAnswers() {
    for (uint8_t link = 0; link < firmware::kLinks; ++link) {
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
    auto& vehicle = firmware::vehicle;
    vehicle.armed = how & 1;
    vehicle.estimate.flying = how & 2;
    vehicle.home.set = vehicle.estimate.known = how & 4;
    vehicle.gps.fix = how & 4 ? firmware::GpsFix::three_d : firmware::GpsFix::none;
}

}  // namespace fuzz
