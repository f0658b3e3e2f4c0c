// SPDX-License-Identifier: GPL-3.0-or-later
// A receiver that speaks NMEA at the rate it was made for and listens to nobody.
#pragma once
#include "simulator/devices/gps_receiver.hpp"

namespace simulator {

struct NmeaOptions : GpsOptions {
    uint32_t baud = 9600;
    uint16_t period_ms = 1000;
    std::string talker = "GN";
    bool few = false;  // GGA and RMC alone
};

class NmeaGps : public GpsReceiver {
public:
    explicit NmeaGps(uint64_t seed = 1, const SensorErrors& errors = {},
                     const NmeaOptions& options = {});

private:
    void report(const GpsFix& fix, uint64_t now_us) override;

    const std::string talker_;
    const bool few_;
};

}  // namespace simulator
