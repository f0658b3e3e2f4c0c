// SPDX-License-Identifier: GPL-3.0-or-later
// The GPS driver on the doubles of the hardware, by itself or with one of the simulator's receivers
// at the other end of its line.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "drivers/gps.hpp"
#include "fakes/fakes.hpp"
#include "simulator/devices/gps_kinds.hpp"
#include "simulator/line_noise.hpp"
#include "simulator/world.hpp"

namespace gps_line {

inline fakes::Serial& port() { return fakes::serial(hal::Port::gps); }

struct Driver : ::testing::Test {
    drivers::Gps driver;
    uint32_t now_ms = 0;
    int fixes = 0;

    Driver() {
        fakes::reset();
        driver.start();
    }
    bool step() {
        now_ms += 10;
        const bool fresh = driver.step(now_ms);
        fixes += fresh;
        return fresh;
    }
};

// Bytes given as if they had come over the line.
struct Bytes : Driver {
    Bytes() {
        for (int i = 0; i < 60; ++i) step();  // past greeting and call
        port().out.clear();
    }
    int receive(const std::vector<uint8_t>& bytes) {
        port().receive(bytes);
        const int before = fixes;
        while (!port().in.empty()) step();
        step();
        return fixes - before;
    }
    int receive(const std::string& text) {
        return receive(std::vector<uint8_t>(text.begin(), text.end()));
    }
};

// Time passes for the line, the receiver and the driver alike.
struct Line : Driver {
    simulator::Truth truth{};
    std::unique_ptr<simulator::GpsReceiver> gps;

    Line() {
        truth.latitude_deg = -33.9;
        truth.longitude_deg = 151.2;
        truth.altitude_m = 57.3;
        truth.velocity_north_mps = 3;
        truth.velocity_east_mps = -4;
        truth.velocity_down_mps = 0.5;
    }
    void plug(std::unique_ptr<simulator::GpsReceiver> receiver) { gps = std::move(receiver); }
    simulator::GpsOptions poweredNow() const {
        simulator::GpsOptions options;
        options.acquire_s = 1.5;
        options.powered_us = now_ms * 1000ull;
        return options;
    }
    void power(const std::string& kind, uint32_t baud = 0) {
        plug(simulator::makeGps(kind, baud, 1, simulator::SensorErrors::none(), poweredNow()));
    }
    void fly(uint32_t for_ms) {
        for (uint32_t ms = 0; ms < for_ms; ms += 10) {
            for (int i = 1; i <= 10; ++i) exchange(now_ms * 1000ull + i * 1000ull);
            constexpr size_t kRing = 31;
            port().room = static_cast<uint8_t>(kRing - std::min(kRing, port().out.size()));
            step();
        }
    }
    // Until what is asked for, at most this long; how long it took.
    template <class Condition>
    uint32_t flyUntil(Condition holds, uint32_t max_ms) {
        const uint32_t began_ms = now_ms;
        while (!holds() && now_ms - began_ms < max_ms) fly(10);
        return now_ms - began_ms;
    }

private:
    void exchange(uint64_t now_us) {
        truth.time_us = now_us;
        if (port().opened.size() != opens_) port().out.clear();  // as the port forgets
        opens_ = port().opened.size();
        if (gps->nextEvent_us() <= now_us) gps->run(truth, now_us);
        sent_ = port().out.empty() ? 0 : sent_ + port().baud / 10000.0;
        while (sent_ >= 1 && !port().out.empty()) {
            gps->receive(port().out.front(), port().baud, now_us);
            port().out.erase(port().out.begin());
            sent_ -= 1;
        }
        while (const auto byte = gps->nextByte(now_us))
            if (const auto heard = noise_.through(*byte, gps->baud(), port().baud))
                port().in.push_back(*heard);
    }

    simulator::LineNoise noise_;
    double sent_ = 0;  // bytes the line has had time for
    size_t opens_ = 0;
};

}  // namespace gps_line
