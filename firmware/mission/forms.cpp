// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/mission/forms.hpp"

#include <string.h>

#include "core/maths.hpp"
#include "core/rom.hpp"
#include "core/seldom.hpp"

namespace firmware {
namespace mission {

namespace {

using ::mission::Record;

// Divided: the factor 0.01 rounds another way, and what was uploaded has to come back.
SELDOM float hundredthsOf(int32_t count) { return static_cast<float>(count) / 100; }

// One unit of the stored byte is 10 s.
MissionResult encodeTime(const float* parameter, Record& record, EncodeWarnings& warnings) {
    const float seconds = orZero(parameter[1]);
    if (!(seconds >= 0 && seconds <= 2550)) return wrong(1);
    record.p1 = static_cast<uint8_t>(core::rounded(seconds / 10));
    if (record.p1 == 0 && core::isPositive(seconds)) record.p1 = 1;
    flagRounding(seconds, core::real(record.p1) * 10.0f, warnings);
    return kFine;
}
void decodeTime(const Record& record, float* parameter) {
    parameter[1] = core::real(record.p1) * 10.0f;
}

MissionResult encodeClimb(const float* parameter, Record& record, EncodeWarnings& warnings) {
    const float rate_mps = orZero(parameter[1]);
    if (!(core::isPositive(rate_mps) && rate_mps < 1000)) return wrong(1);
    const int32_t rate_cms = core::inHundredths(rate_mps);
    record.p1 = rate_cms > 255 ? 255 : static_cast<uint8_t>(rate_cms);
    record.p3 = rate_cms > 255 ? rate_cms : 0;
    flagRounding(rate_mps, hundredthsOf(rate_cms), warnings);
    return kFine;
}
void decodeClimb(const Record& record, float* parameter) {
    parameter[1] = hundredthsOf(record.p3 != 0 ? record.p3 : record.p1);
}

// Rounded, and in hundredths when that is not the value.
SELDOM void putExactly(float value, int32_t& whole, int32_t& hundredths, EncodeWarnings& warnings) {
    whole = core::rounded(value);
    if (static_cast<float>(whole) == value) return;
    hundredths = core::inHundredths(value);
    flagRounding(value, hundredthsOf(hundredths), warnings);
}

MissionResult encodeSpeed(const float* parameter, Record& record, EncodeWarnings& warnings) {
    const float speed_mps = isnan(parameter[2]) ? -1 : parameter[2];
    const float throttle_pct = isnan(parameter[3]) ? -1 : parameter[3];
    if (!(speed_mps == -1 || (core::isPositive(speed_mps) && speed_mps < 1000))) return wrong(2);
    if (!(throttle_pct >= -1 && throttle_pct <= 100)) return wrong(3);
    putExactly(speed_mps, record.p2, record.p4, warnings);
    record.p3 = core::rounded(throttle_pct);
    flagRounding(throttle_pct, static_cast<float>(record.p3), warnings);
    return kFine;
}
void decodeSpeed(const Record& record, float* parameter) {
    const bool exact = record.p2 >= 0 && record.p4 != 0;  // below 0: no change, whatever p4 holds
    parameter[2] = exact ? hundredthsOf(record.p4) : static_cast<float>(record.p2);
    parameter[3] = static_cast<float>(record.p3);
}

MissionResult encodeParameter(const float* parameter, Record& record, EncodeWarnings&) {
    const float value = orZero(parameter[2]);
    if (!isfinite(value)) return wrong(2);
    const float nearest = core::limit(value, -8388608.0f, 8388607.0f);
    record.p2 = core::rounded(nearest);
    if (static_cast<float>(record.p2) != value) memcpy(&record.p3, &value, sizeof value);
    return kFine;
}
void decodeParameter(const Record& record, float* parameter) {
    parameter[2] = static_cast<float>(record.p2);
    if (record.p3 != 0) memcpy(&parameter[2], &record.p3, sizeof record.p3);
}

MissionResult encodeDistance(const float* parameter, Record& record, EncodeWarnings& warnings) {
    constexpr float kFarthest_m = 10000;
    const float distance_m = orZero(parameter[1]);
    if (!(distance_m >= 0 && distance_m <= kFarthest_m)) return wrong(1);
    putExactly(distance_m, record.p2, record.p3, warnings);
    const bool none = record.p2 == 0 && record.p3 == 0;
    return none && !core::isZero(distance_m) ? wrong(1) : kFine;
}
void decodeDistance(const Record& record, float* parameter) {
    parameter[1] = record.p3 != 0 ? hundredthsOf(record.p3) : static_cast<float>(record.p2);
}

// clang-format off
constexpr FormRow kFormRows[] ROM = {
    //             p1 p2 p3 p4  parts               special
    /* none */      {{0, 0, 0, 0}, 0,                  0,               nullptr,         nullptr},
    /* waypoint */  {{2, 0, 0, 0}, kPlace,             0,               nullptr,         nullptr},
    /* unlimited */ {{0, 0, 0, 0}, kPlace | kDirection, 0,              nullptr,         nullptr},
    /* turns */     {{1, 0, 0, 0}, kPlace | kDirection, 0,              nullptr,         nullptr},
    /* time */      {{0, 0, 0, 0}, kPlace | kDirection, use(1),         encodeTime,      decodeTime},
    /* place */     {{0, 0, 0, 0}, kPlace,             0,               nullptr,         nullptr},
    /* takeoff */   {{1, 0, 0, 0}, kAltitude,          0,               nullptr,         nullptr},
    /* climb */     {{0, 0, 0, 0}, kAltitude,          use(1),          encodeClimb,     decodeClimb},
    /* seconds */   {{0, 0, 1, 0}, 0,                  0,               nullptr,         nullptr},
    /* jump */      {{1, 0, 2, 0}, 0,                  0,               nullptr,         nullptr},
    /* speed */     {{1, 0, 0, 0}, 0,                  use(2) | use(3), encodeSpeed,     decodeSpeed},
    /* place_p1 */  {{1, 0, 0, 0}, kPlace,             0,               nullptr,         nullptr},
    /* parameter */ {{1, 0, 0, 0}, 0,                  use(2),          encodeParameter, decodeParameter},
    /* p1_p2 */     {{1, 2, 0, 0}, 0,                  0,               nullptr,         nullptr},
    /* p1_p2_p3 */  {{1, 2, 3, 0}, 0,                  0,               nullptr,         nullptr},
    /* repeat */    {{1, 3, 4, 2}, 0,                  0,               nullptr,         nullptr},
    /* p1 */        {{1, 0, 0, 0}, 0,                  0,               nullptr,         nullptr},
    /* p1_to_p4 */  {{1, 2, 3, 4}, 0,                  0,               nullptr,         nullptr},
    /* to_height */ {{1, 0, 0, 0}, kPlace | kDirectionInTwo, 0,         nullptr,         nullptr},
    /* mount */     {{0, 1, 2, 3}, kNumberInAltitude,  0,               nullptr,         nullptr},
    /* distance */  {{0, 0, 0, 0}, 0,                  use(1),          encodeDistance,  decodeDistance},
};
// clang-format on
static_assert(core::count(kFormRows) == FormOf::kForms, "a form has no row");

}  // namespace

FormRow formRow(uint8_t form) { return core::romRead(kFormRows[form]); }

}  // namespace mission
}  // namespace firmware
