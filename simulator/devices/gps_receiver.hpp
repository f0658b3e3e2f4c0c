// SPDX-License-Identifier: GPL-3.0-or-later
// A GPS on its serial line: measures, with the errors of the table, and sends what its make makes
// of that, byte by byte at its own rate. By itself it is a connector with nothing in it.
#pragma once
#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "simulator/devices/errors.hpp"
#include "simulator/devices/faults.hpp"
#include "simulator/devices/gps_fix.hpp"
#include "simulator/devices/random.hpp"

namespace simulator {

struct Truth;

struct GpsOptions {
    double acquire_s = 3;  // from power-on to the first fix
    int satellites = 9;
    uint64_t powered_us = 0;
};

class GpsReceiver {
public:
    GpsReceiver(uint64_t seed, const SensorErrors& errors, const GpsOptions& options, uint32_t baud,
                uint16_t period_ms);
    virtual ~GpsReceiver() = default;

    // A byte from the autopilot, sent at that line rate; another rate than the module's arrives
    // as garbage.
    void receive(uint8_t byte, uint32_t baud, uint64_t now_us);

    // The next byte that is complete on the line by now. A listener at another rate than baud()
    // does not see this byte but garbage: that is for the board to do.
    std::optional<uint8_t> nextByte(uint64_t now_us);
    uint64_t nextByte_us() const;  // when that is; UINT64_MAX: nothing to send yet
    uint32_t baud() const { return baud_; }

    // When run() wants to be called next, to measure or to report. World does that.
    uint64_t nextEvent_us() const;
    void run(const Truth& truth, uint64_t now_us);

    // Antenna covered: no fix until uncovered, and then at once.
    void cover(bool covered) { covered_ = covered; }
    // Lost, its line is silent.
    void fail(FaultKind kind) { fault_ = kind; }

protected:
    virtual void take(uint8_t, uint64_t) {}          // a byte it heard
    virtual void report(const GpsFix&, uint64_t) {}  // sends what it makes of a fix

    void send(const std::vector<uint8_t>& bytes, uint64_t now_us);
    void setBaud(uint32_t baud, uint64_t now_us);
    void setPeriod(uint16_t period_ms, uint64_t now_us);
    uint16_t period_ms() const { return period_ms_; }

    const SensorErrors errors_;

private:
    void measure(const Truth& truth, uint64_t now_us);
    void addErrors(GpsFix& fix);
    uint64_t byteEnd_us(uint64_t bytes) const;

    const GpsOptions options_;
    Random random_;
    std::array<Wander, 3> wander_;
    uint32_t baud_;
    uint16_t period_ms_;
    uint64_t next_measurement_us_, last_measurement_us_;
    std::deque<GpsFix> waiting_;  // measured, not yet old enough to be sent
    std::deque<uint8_t> line_;
    uint64_t line_start_us_ = 0;  // the first byte of line_ started then
    uint64_t line_sent_ = 0;      // bytes sent since line_start_us_
    FaultKind fault_ = FaultKind::none;
    std::optional<GpsFix> held_;  // while it is stuck
    bool covered_ = false;
};

}  // namespace simulator
