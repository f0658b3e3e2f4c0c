// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/gps_kinds.hpp"

#include "simulator/devices/mtk_gps.hpp"
#include "simulator/devices/nmea_gps.hpp"
#include "simulator/devices/ublox_gps.hpp"

namespace simulator {
namespace {

struct Order {
    uint32_t baud;
    uint64_t seed;
    const SensorErrors& errors;
    const GpsOptions& options;
};
using Made = std::unique_ptr<GpsReceiver>;

template <class Gps, class Options>
Made make(const Order& order, Options options) {
    static_cast<GpsOptions&>(options) = order.options;
    if (order.baud != 0) options.baud = order.baud;
    return std::make_unique<Gps>(order.seed, order.errors, options);
}

Made ublox(const Order& order) { return make<UbloxGps>(order, UbloxOptions{}); }
Made ubloxM9(const Order& order) {
    UbloxOptions options;
    options.generation = UbloxGeneration::m9;
    options.baud = 38400;
    return make<UbloxGps>(order, options);
}
Made ubloxM10(const Order& order) {
    UbloxOptions options;
    options.generation = UbloxGeneration::m10;
    return make<UbloxGps>(order, options);
}
Made mtk(const Order& order, bool version_19) {
    MtkOptions options;
    options.version_19 = version_19;
    return make<MtkGps>(order, options);
}
Made mtk16(const Order& order) { return mtk(order, false); }
Made mtk19(const Order& order) { return mtk(order, true); }
Made nmea(const Order& order) {
    NmeaOptions options;
    if (order.baud >= 38400) options.period_ms = 200;  // who pays for speed wants it
    return make<NmeaGps>(order, options);
}

struct Kind {
    const char* name;
    Made (*make)(const Order& order);
};
constexpr Kind kKinds[] = {{"ublox", ublox}, {"ublox_m9", ubloxM9}, {"ublox_m10", ubloxM10},
                           {"mtk16", mtk16}, {"mtk19", mtk19},      {"nmea", nmea}};

}  // namespace

std::vector<std::string> gpsKinds() {
    std::vector<std::string> names;
    for (const Kind& kind : kKinds) names.push_back(kind.name);
    return names;
}

std::unique_ptr<GpsReceiver> makeGps(const std::string& kind, uint32_t baud, uint64_t seed,
                                     const SensorErrors& errors, const GpsOptions& options) {
    for (const Kind& each : kKinds)
        if (kind == each.name) return each.make({baud, seed, errors, options});
    constexpr uint32_t kNoBaud = 9600;
    constexpr uint16_t kNoPeriod_ms = 60'000;
    return std::make_unique<GpsReceiver>(seed, errors, options, kNoBaud, kNoPeriod_ms);
}

}  // namespace simulator
