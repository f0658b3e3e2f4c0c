// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/mtk_gps.hpp"

#include <cstdio>

#include "simulator/devices/nmea_reports.hpp"

namespace simulator {
namespace {

constexpr uint16_t kFactoryPeriod_ms = 1000, kShortestPeriod_ms = 200;

void put(std::vector<uint8_t>& bytes, uint32_t value, int size) {
    for (int i = 0; i < size; ++i) bytes.push_back(static_cast<uint8_t>(value >> 8 * i));
}

uint32_t scaled(double value, double by) {
    return static_cast<uint32_t>(static_cast<int32_t>(std::lround(value * by)));
}

std::vector<uint8_t> binaryMessage(const GpsFix& fix, bool version_19) {
    const double angle = version_19 ? 1e7 : 1e6;
    const Utc time = utc(fix);
    const uint32_t of_day = ((time.hour * 100 + time.minute) * 100 + time.second) * 1000 + time.ms;
    std::vector<uint8_t> bytes = {static_cast<uint8_t>(version_19 ? 0xD1 : 0xD0), 0xDD, 32};
    put(bytes, scaled(fix.latitude_deg, angle), 4);
    put(bytes, scaled(fix.longitude_deg, angle), 4);
    put(bytes, scaled(fix.altitude_m, 100), 4);
    put(bytes, scaled(groundSpeed_mps(fix), 100), 4);
    put(bytes, scaled(course_deg(fix), 100), 4);
    put(bytes, static_cast<uint32_t>(fix.satellites), 1);
    put(bytes, fix.valid ? 3 : 1, 1);
    put(bytes, (time.day * 100 + time.month) * 100 + time.year % 100, 4);
    put(bytes, version_19 ? of_day : of_day / 10, 4);
    put(bytes, fix.valid ? kDop : kNoDop, 2);
    uint8_t a = 0, b = 0;
    for (size_t i = 2; i < bytes.size(); ++i) {
        a = static_cast<uint8_t>(a + bytes[i]);
        b = static_cast<uint8_t>(b + a);
    }
    bytes.push_back(a);
    bytes.push_back(b);
    return bytes;
}

}  // namespace

MtkGps::MtkGps(uint64_t seed, const SensorErrors& errors, const MtkOptions& options)
    : GpsReceiver(seed, errors, options, options.baud,
                  options.binary ? kShortestPeriod_ms : kFactoryPeriod_ms),
      version_19_(options.version_19),
      binary_(options.binary) {}

void MtkGps::take(uint8_t byte, uint64_t now_us) {
    parser_.take(byte);
    if (const auto sentence = parser_.sentence()) obey(*sentence, now_us);
}

// $PGCMD,16,b,... turns the binary message on with zeros; $PMTKnnn,value is acknowledged with
// $PMTK001,nnn,3 (2: failed).
void MtkGps::obey(const std::string& sentence, uint64_t now_us) {
    int command = 0, value = 0;
    if (std::sscanf(sentence.c_str(), "PGCMD,%d,%d", &command, &value) == 2) {
        if (command == 16) binary_ = value == 0;
    } else if (std::sscanf(sentence.c_str(), "PMTK%d,%d", &command, &value) == 2) {
        const bool done = configure(command, value, now_us);
        const std::string answer =
            nmeaSentence("PMTK001," + std::to_string(command) + (done ? ",3" : ",2"));
        send({answer.begin(), answer.end()}, now_us);
    }
}

bool MtkGps::configure(int command, int value, uint64_t now_us) {
    switch (command) {
        case 220:
            if (value < kShortestPeriod_ms || value > 10'000) return false;
            setPeriod(static_cast<uint16_t>(value), now_us);
            return true;
        case 251:
            if (value < 4800 || value > 115'200) return false;
            setBaud(static_cast<uint32_t>(value), now_us);
            return true;
        case 301:
        case 313:
        case 397:
            return true;  // without effect here
        default:
            return false;
    }
}

void MtkGps::report(const GpsFix& fix, uint64_t now_us) {
    if (binary_) return send(binaryMessage(fix, version_19_), now_us);
    for (const auto report : {nmeaGga, nmeaGsa, nmeaRmc, nmeaVtg}) send(report(fix, "GP"), now_us);
}

}  // namespace simulator
