// SPDX-License-Identifier: GPL-3.0-or-later
// A u-blox 6 or 7 on its serial line (u-blox 6 Receiver Description, GPS.G6-SW-10018): starts as
// the factory made it, with NMEA at 9600 baud, and obeys the UBX and PUBX configuration messages.
#pragma once
#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "simulator/devices/errors.hpp"
#include "simulator/devices/random.hpp"
#include "simulator/devices/ublox_parser.hpp"
#include "simulator/devices/ublox_reports.hpp"

namespace simulator {

struct Truth;

struct UbloxOptions {
    uint32_t baud = 9600;
    bool nmea = true;      // GGA and RMC at start
    bool ubx = false;      // POSLLH, STATUS, SOL and VELNED at start, at 5 Hz
    double acquire_s = 3;  // from power-on to the first fix
    int satellites = 9;
};

class UbloxGps {
public:
    explicit UbloxGps(uint64_t seed = 1, const SensorErrors& errors = {},
                      const UbloxOptions& options = {});

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

private:
    void measure(const Truth& truth, uint64_t now_us);
    void report(const GpsFix& fix, uint64_t now_us);
    void obey(const UbxFrame& frame, uint64_t now_us);
    void obey(const std::string& sentence, uint64_t now_us);
    bool configure(const UbxFrame& frame, uint64_t now_us);
    bool configurePort(const UbxFrame& frame, uint64_t now_us);
    bool configureMessage(const UbxFrame& frame);
    bool configureRate(const UbxFrame& frame, uint64_t now_us);
    bool configureNavigation(const UbxFrame& frame);
    bool poll(const UbxFrame& frame, uint64_t now_us);
    void setPort(uint32_t baud, uint16_t protocols_out, uint64_t now_us);
    void send(const std::vector<uint8_t>& bytes, uint64_t now_us);
    uint64_t byteEnd_us(uint64_t bytes) const;

    const SensorErrors errors_;
    const UbloxOptions options_;
    Random random_;
    std::array<Wander, 3> wander_;
    UbloxParser parser_;
    uint32_t baud_;
    uint16_t protocols_out_;  // bit 0 UBX, bit 1 NMEA
    uint16_t period_ms_;
    std::array<uint8_t, 36> navigation_;         // CFG-NAV5
    std::array<uint8_t, kReportCount> rates_{};  // every how many fixes; 0 never
    std::array<uint8_t, kReportCount> countdown_{};
    uint64_t next_measurement_us_ = 0, last_measurement_us_ = 0;
    std::deque<GpsFix> waiting_;  // measured, not yet old enough to be sent
    std::deque<uint8_t> line_;
    uint64_t line_start_us_ = 0;  // the first byte of line_ started then
    uint64_t line_sent_ = 0;      // bytes sent since line_start_us_
    bool covered_ = false;
};

}  // namespace simulator
