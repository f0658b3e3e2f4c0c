// SPDX-License-Identifier: GPL-3.0-or-later
// A MediaTek MT3329 with the DIYDrones firmware 1.6 or 1.9: starts with NMEA once a second, obeys
// PMTK sentences, and sends its one binary message when PGCMD,16 asks for it.
#pragma once
#include <array>

#include "simulator/devices/gps_receiver.hpp"
#include "simulator/devices/ublox_parser.hpp"

namespace simulator {

struct MtkOptions : GpsOptions {
    uint32_t baud = 38400;
    bool version_19 = false;
    bool binary = false;  // and five a second: what a receiver with a backup battery remembers
};

class MtkGps : public GpsReceiver {
public:
    explicit MtkGps(uint64_t seed = 1, const SensorErrors& errors = {},
                    const MtkOptions& options = {});

private:
    void take(uint8_t byte, uint64_t now_us) override;
    void report(const GpsFix& fix, uint64_t now_us) override;
    void obey(const std::string& sentence, uint64_t now_us);
    bool configure(int command, int value, uint64_t now_us);

    const bool version_19_;
    bool binary_;
    UbloxParser parser_;
};

}  // namespace simulator
