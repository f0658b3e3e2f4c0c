// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/nmea.hpp"

#include "core/rom.hpp"
#include "core/seldom.hpp"

namespace drivers {
namespace {

// What a field is. Numbers come with so many decimals.
enum Field : uint8_t {
    skipped,
    time_of_day,  // hhmmss.sss
    latitude,     // ddmm.mmmmm
    north_south,
    longitude,  // dddmm.mmmmm
    east_west,
    status,      // A or V
    quality,     // 0 none, 1..5 a fix, more: not measured
    satellites,  // used
    dilution,
    altitude,
    knots,
    course,
    date,       // ddmmyy
    dimension,  // 1, 2, 3
    fields_end
};

// clang-format off
constexpr uint8_t kDecimals[] ROM = {0, 3, 5, 0, 5, 0, 0, 0, 0, 2, 2, 3, 2, 0, 0};

constexpr uint8_t kMaxFields = 9;
struct Layout {
    char type[3];
    uint8_t fields[kMaxFields];
};
constexpr Layout kLayouts[] ROM = {
    {{'G', 'G', 'A'}, {time_of_day, latitude, north_south, longitude, east_west, quality,
                       satellites, dilution, altitude}},
    {{'R', 'M', 'C'}, {time_of_day, status, skipped, skipped, skipped, skipped,
                       knots, course, date}},
    {{'G', 'S', 'A'}, {skipped, dimension}},
};
// clang-format on
enum : uint8_t { gga, rmc, gsa };
static_assert(core::count(kDecimals) == fields_end, "every field has its decimals");

constexpr int32_t kNone = INT32_MIN;  // the field is empty

struct Values {
    int32_t of[fields_end];
};

// One more digit; too many are odd.
int32_t tenfold(int32_t sum, uint8_t digit, bool& odd) {
    constexpr int32_t kMax = INT32_MAX / 10 - 1;
    if (sum > kMax) odd = true;
    return odd ? 0 : sum * 10 + digit;
}

// The number at `at`, in units of its last decimal; further ones are left out. A letter is itself.
int32_t value(const uint8_t*& at, uint8_t decimals, bool& odd) {
    if (*at >= 'A') return *at++;
    const bool negative = *at == '-';
    if (negative) ++at;
    if (*at == ',' || *at == '*') return kNone;
    int32_t sum = 0;
    bool fraction = false;
    for (;; ++at) {
        const uint8_t digit = static_cast<uint8_t>(*at - '0');
        if (digit <= 9) {
            if (fraction && decimals == 0) continue;
            if (fraction) --decimals;
            sum = tenfold(sum, digit, odd);
        } else if (*at == '.' && !fraction) {
            fraction = true;
        } else {
            break;
        }
    }
    for (; decimals > 0; --decimals) sum = tenfold(sum, 0, odd);
    return negative ? -sum : sum;
}

// The fields by what they are; false: one of them is no number, or too large a one.
bool take(const uint8_t* at, uint8_t layout, Values& values) {
    for (int32_t& each : values.of) each = kNone;
    bool odd = false;
    for (uint8_t i = 0; i < kMaxFields && *at == ','; ++i) {
        const uint8_t field = core::romRead(kLayouts[layout].fields[i]);
        ++at;
        if (field != skipped) {
            values.of[field] = value(at, core::romRead(kDecimals[field]), odd);
            if (odd || (*at != ',' && *at != '*')) return false;
        }
        while (*at != ',' && *at != '*') ++at;
    }
    return true;
}

// From (d)ddmm.mmmmm to 1e-7 degrees.
SELDOM int32_t angle_e7(int32_t degrees_minutes, int32_t letter, uint8_t negative, bool& odd) {
    constexpr int32_t kDegree = 10000000;
    const int32_t minutes_e5 = degrees_minutes % kDegree;
    if (degrees_minutes < 0 || minutes_e5 > 6000000) odd = true;
    if (odd) return 0;
    const int32_t angle = degrees_minutes - minutes_e5 + (minutes_e5 * 5 + 1) / 3;
    return letter == negative ? -angle : angle;
}

void takeGga(const Values& values, GpsEpoch& epoch) {
    const int32_t* of = values.of;
    GpsFix& fix = epoch.fix;
    constexpr int32_t kMaxDilution = 9999;
    const bool known = of[dilution] >= 0 && of[dilution] < kMaxDilution;
    fix.satellites = of[satellites] < 0 ? 0 : static_cast<uint8_t>(of[satellites]);
    fix.hdop_c = static_cast<uint16_t>(known ? of[dilution] : kMaxDilution);
    if (of[quality] < 1 || of[quality] > 5) {
        epoch.parts |= GpsEpoch::kUnfixed;
        return;
    }
    fix.altitude_cm = of[altitude];  // none is too low
    fix.latitude_e7 = angle_e7(of[latitude], of[north_south], 'S', epoch.odd);
    fix.longitude_e7 = angle_e7(of[longitude], of[east_west], 'W', epoch.odd);
}

void takeRmc(const Values& values, GpsEpoch& epoch) {
    const int32_t* of = values.of;
    epoch.setUtc(static_cast<uint32_t>(of[time_of_day]), static_cast<uint32_t>(of[date]));
    if (of[status] != 'A') {
        epoch.parts |= GpsEpoch::kUnfixed;
        return;
    }
    constexpr int32_t kFastest = 600000;  // thousandths of a knot
    const int32_t speed = of[knots];
    if (speed < 0 || speed > kFastest) epoch.odd = true;
    // a knot is 1852 m an hour; standing, many receivers know no course
    epoch.setSpeed(epoch.odd ? 0 : static_cast<uint32_t>(speed) * 463 / 9000,
                   of[course] == kNone ? 0 : static_cast<uint32_t>(of[course]));
    epoch.velocityFromCourse();
}

// GSA's word where there is one.
GpsFixType fixType(const GpsEpoch& epoch) {
    if (epoch.parts & GpsEpoch::kUnfixed) return GpsFixType::none;
    if (epoch.type != GpsFixType::unknown) return epoch.type;
    return epoch.fix.satellites < 4 ? GpsFixType::two_d : GpsFixType::three_d;
}

bool is(const uint8_t* type, uint8_t layout) {
    for (uint8_t i = 0; i < 3; ++i)
        if (type[i] != core::romRead(kLayouts[layout].type[i])) return false;
    return true;
}

}  // namespace

bool isOfNmea(const uint8_t* sentence) { return sentence[1] != 'P'; }

bool readNmea(const uint8_t* sentence, GpsEpoch& epoch) {
    uint8_t layout = 0;
    while (!is(sentence + 3, layout))
        if (++layout == core::count(kLayouts)) return false;
    Values values;
    if (!take(sentence + 6, layout, values)) {
        epoch.refuse();
        return false;
    }
    if (layout == gsa) {
        const int32_t dimensions = values.of[dimension];
        if (dimensions >= 1 && dimensions <= 3) epoch.type = static_cast<GpsFixType>(dimensions);
        return false;
    }
    const uint8_t part = layout == gga ? GpsEpoch::kPosition : GpsEpoch::kVelocity;
    epoch.takes(part, static_cast<uint32_t>(values.of[time_of_day]));
    if (layout == gga) {
        takeGga(values, epoch);
    } else {
        takeRmc(values, epoch);
    }
    if (!epoch.whole()) return false;
    epoch.finish(fixType(epoch));
    epoch.parts = 0;  // without a time the next pair looks like this one
    return true;
}

}  // namespace drivers
