// SPDX-License-Identifier: GPL-3.0-or-later
// A u-blox on its serial line: starts as the factory made it, with NMEA, and obeys the
// configuration messages of its generation. 6 (u-blox 6 Receiver Description, GPS.G6-SW-10018; 7
// and 8 take the same ones): CFG-PRT, CFG-MSG, CFG-RATE, CFG-NAV5 and PUBX,41. M9 (SPG 4.04
// Interface Description, UBX-19035940): those and CFG-VALSET, without NAV-SOL. M10 (SPG 5.10,
// UBX-21035062): CFG-VALSET and PUBX,41 alone.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "simulator/devices/gps_receiver.hpp"
#include "simulator/devices/ublox_parser.hpp"
#include "simulator/devices/ublox_reports.hpp"

namespace simulator {

enum class UbloxGeneration { six, m9, m10 };

struct UbloxOptions : GpsOptions {
    UbloxGeneration generation = UbloxGeneration::six;
    uint32_t baud = 9600;
    bool nmea = true;  // RMC, VTG, GGA, GSA, GSV and GLL at start
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
    bool knows(const UbxFrame& frame) const;
    bool setValues(const UbxFrame& frame, uint64_t now_us);
    bool setValue(uint32_t key, uint32_t value, uint64_t now_us);
    uint8_t& rateOf(uint8_t message_class, uint8_t id);
    bool sends(uint8_t message_class, uint8_t id) const;
    bool poll(const UbxFrame& frame, uint64_t now_us);
    void setPort(uint32_t baud, uint16_t protocols_out, uint64_t now_us);

    UbloxGeneration generation_;
    UbloxParser parser_;
    uint16_t protocols_out_;                     // bit 0 UBX, bit 1 NMEA
    std::array<uint8_t, 36> navigation_;         // CFG-NAV5
    std::array<uint8_t, kReportCount> rates_{};  // every how many fixes; 0 never
    std::array<uint8_t, kReportCount> countdown_{};
};

}  // namespace simulator
