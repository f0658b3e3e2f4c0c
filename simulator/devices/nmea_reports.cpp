// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/nmea_reports.hpp"

#include <algorithm>
#include <cstdio>

#include "simulator/devices/ublox_parser.hpp"

namespace simulator {
namespace {

constexpr double kKnots = 3600.0 / 1852;

// ddmm.mmmmm,N
std::string nmeaAngle(double degrees, int digits, char positive, char negative) {
    const double size = std::fabs(degrees);
    const int whole = static_cast<int>(size);
    char text[32];
    std::snprintf(text, sizeof text, "%0*d%08.5f,%c", digits, whole, (size - whole) * 60,
                  degrees < 0 ? negative : positive);
    return text;
}
std::string nmeaPlace(const GpsFix& fix) {
    if (!fix.valid) return ",,,";
    return nmeaAngle(fix.latitude_deg, 2, 'N', 'S') + "," +
           nmeaAngle(fix.longitude_deg, 3, 'E', 'W');
}
std::string nmeaTime(const GpsFix& fix) {
    const Utc time = utc(fix);
    char text[48];
    std::snprintf(text, sizeof text, "%02u%02u%02u.%02u", time.hour, time.minute, time.second,
                  time.ms / 10);
    return text;
}
std::vector<uint8_t> sentence(const std::string& body) {
    const std::string text = nmeaSentence(body);
    return {text.begin(), text.end()};
}

}  // namespace

std::vector<uint8_t> nmeaGga(const GpsFix& fix, const std::string& talker) {
    char rest[64] = "0,00,99.99,,,,,,";
    if (fix.valid)
        std::snprintf(rest, sizeof rest, "1,%02d,%.2f,%.1f,M,%.1f,M,,", fix.satellites,
                      kDop / 100.0, fix.altitude_m, kGeoid_m);
    return sentence(talker + "GGA," + nmeaTime(fix) + "," + nmeaPlace(fix) + "," + rest);
}

std::vector<uint8_t> nmeaRmc(const GpsFix& fix, const std::string& talker) {
    const Utc time = utc(fix);
    char motion[48] = ",", date[48];
    if (fix.valid)
        std::snprintf(motion, sizeof motion, "%.3f,%.2f", groundSpeed_mps(fix) * kKnots,
                      course_deg(fix));
    std::snprintf(date, sizeof date, "%02u%02u%02u", time.day, time.month, time.year % 100);
    return sentence(talker + "RMC," + nmeaTime(fix) + (fix.valid ? ",A," : ",V,") + nmeaPlace(fix) +
                    "," + motion + "," + date + ",,," + (fix.valid ? "A" : "N"));
}

std::vector<uint8_t> nmeaVtg(const GpsFix& fix, const std::string& talker) {
    char motion[64] = ",T,,M,,N,,K,N";
    if (fix.valid)
        std::snprintf(motion, sizeof motion, "%.2f,T,,M,%.3f,N,%.3f,K,A", course_deg(fix),
                      groundSpeed_mps(fix) * kKnots, groundSpeed_mps(fix) * 3.6);
    return sentence(talker + "VTG," + motion);
}

std::vector<uint8_t> nmeaGll(const GpsFix& fix, const std::string& talker) {
    return sentence(talker + "GLL," + nmeaPlace(fix) + "," + nmeaTime(fix) +
                    (fix.valid ? ",A,A" : ",V,N"));
}

// Four satellites in a sentence; where in the sky they are does not matter here.
std::vector<uint8_t> nmeaGsv(const GpsFix& fix, const std::string& talker) {
    const int in_view = fix.satellites, sentences = std::max(1, (in_view + 3) / 4);
    std::vector<uint8_t> all;
    for (int number = 1; number <= sentences; ++number) {
        char text[32];
        std::snprintf(text, sizeof text, "GSV,%d,%d,%02d", sentences, number, in_view);
        std::string body = talker + text;
        for (int i = 4 * (number - 1); i < std::min(in_view, 4 * number); ++i) {
            std::snprintf(text, sizeof text, ",%02d,%02d,%03d,%02d", 10 + i, 30, 40 * i % 360, 40);
            body += text;
        }
        const std::vector<uint8_t> bytes = sentence(body);
        all.insert(all.end(), bytes.begin(), bytes.end());
    }
    return all;
}

std::vector<uint8_t> nmeaGsa(const GpsFix& fix, const std::string& talker) {
    std::string used;
    for (int i = 0; i < 12; ++i)
        used += (i < fix.satellites ? std::to_string(10 + i) : std::string()) + ",";
    const char* dilutions = fix.valid ? "1.80,1.00,1.50" : "99.99,99.99,99.99";
    return sentence(talker + "GSA,A," + (fix.valid ? "3," : "1,") + used + dilutions);
}

}  // namespace simulator
