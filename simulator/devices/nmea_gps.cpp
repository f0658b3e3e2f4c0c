// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/nmea_gps.hpp"

#include "simulator/devices/nmea_reports.hpp"

namespace simulator {

NmeaGps::NmeaGps(uint64_t seed, const SensorErrors& errors, const NmeaOptions& options)
    : GpsReceiver(seed, errors, options, options.baud, options.period_ms),
      talker_(options.talker),
      few_(options.few) {}

void NmeaGps::report(const GpsFix& fix, uint64_t now_us) {
    send(nmeaGga(fix, talker_), now_us);
    if (!few_) send(nmeaGsa(fix, talker_), now_us);
    send(nmeaRmc(fix, talker_), now_us);
    if (!few_) send(nmeaVtg(fix, talker_), now_us);
}

}  // namespace simulator
