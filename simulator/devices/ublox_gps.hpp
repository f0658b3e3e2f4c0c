// SPDX-License-Identifier: GPL-3.0-or-later
// A u-blox 6 or 7 on its serial line (u-blox 6 Receiver Description, GPS.G6-SW-10018): starts as
// the factory made it, with NMEA at 9600 baud, and obeys the UBX and PUBX configuration messages.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "simulator/devices/gps_receiver.hpp"
#include "simulator/devices/ublox_parser.hpp"
#include "simulator/devices/ublox_reports.hpp"

namespace simulator {

struct UbloxOptions : GpsOptions {
    uint32_t baud = 9600;
    bool nmea = true;  // GGA and RMC at start
    bool ubx = false;  // POSLLH, STATUS, SOL and VELNED at start, at 5 Hz
};

class UbloxGps : public GpsReceiver {
public:
    explicit UbloxGps(uint64_t seed = 1, const SensorErrors& errors = {},
                      const UbloxOptions& options = {});

private:
    void take(uint8_t byte, uint64_t now_us) override;
    void report(const GpsFix& fix, uint64_t now_us) override;
    void obey(const UbxFrame& frame, uint64_t now_us);
    void obey(const std::string& sentence, uint64_t now_us);
    bool configure(const UbxFrame& frame, uint64_t now_us);
    bool configurePort(const UbxFrame& frame, uint64_t now_us);
    bool configureMessage(const UbxFrame& frame);
    bool configureRate(const UbxFrame& frame, uint64_t now_us);
    bool configureNavigation(const UbxFrame& frame);
    bool poll(const UbxFrame& frame, uint64_t now_us);
    void setPort(uint32_t baud, uint16_t protocols_out, uint64_t now_us);

    UbloxParser parser_;
    uint16_t protocols_out_;                     // bit 0 UBX, bit 1 NMEA
    std::array<uint8_t, 36> navigation_;         // CFG-NAV5
    std::array<uint8_t, kReportCount> rates_{};  // every how many fixes; 0 never
    std::array<uint8_t, kReportCount> countdown_{};
};

}  // namespace simulator
