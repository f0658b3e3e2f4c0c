// SPDX-License-Identifier: GPL-3.0-or-later
#include "geo/position.hpp"

#include "core/file_state.hpp"
#include "core/maths.hpp"

namespace geo {
namespace {

// WGS 84: NIMA TR8350.2, table 3.1.
constexpr float kEquatorRadius_m = 6378137.0f;
constexpr float kEccentricitySquared = 6.69437999e-3f;

constexpr float kRadiansPerE7 = core::kPi / 180.0e7f;
constexpr int32_t kPole_e7 = 900000000;
constexpr int32_t kHalfTurn_e7 = 1800000000;

// Metres of a 1e-7 degree near one latitude. The cosine is carried on by its derivative, so that
// a scale serves 20 km to either side within 1e-5; the trigonometry of a new one costs as much as
// ten differences of places.
constexpr int32_t kBand_e7 = 2000000;
struct Scale {
    int32_t latitude_e7;
    float north_m;            // metres per 1e-7 degree along the meridian
    float east_m;             // and along the parallel
    float east_slope_m;       // change of east_m per 1e-7 degree of latitude
    float convergence_per_m;  // tan(latitude) / (2 R): half the meridians' turn per metre east
    bool known;
};
core::FileState<Scale> cached{};

// Not inlined: it is needed once in 20 km.
__attribute__((noinline)) Scale scaleAt(int32_t latitude_e7) {
    const float latitude_rad = static_cast<float>(latitude_e7) * kRadiansPerE7;
    const float sine = sinf(latitude_rad);
    const float cosine = core::limit<float>(cosf(latitude_rad), 1e-3f, 1.0f);
    const float flattening = 1.0f - kEccentricitySquared * sine * sine;
    const float across_m = kEquatorRadius_m / sqrtf(flattening);  // radius of the parallel's arc
    const float along_m = across_m * (1.0f - kEccentricitySquared) / flattening;
    Scale scale;
    scale.latitude_e7 = latitude_e7;
    scale.north_m = along_m * kRadiansPerE7;
    scale.east_m = across_m * cosine * kRadiansPerE7;
    scale.east_slope_m = -along_m * sine * kRadiansPerE7 * kRadiansPerE7;  // d(N cos) = -M sin
    scale.convergence_per_m = core::half(sine) / (cosine * across_m);
    scale.known = true;
    return scale;
}

// The scale whose band holds this latitude, and its east_m there.
const Scale& scaleFor(int32_t latitude_e7, float& east_m) {
    int32_t away_e7 = latitude_e7 - cached.latitude_e7;
    if (!cached.known || away_e7 > kBand_e7 || away_e7 < -kBand_e7) {
        cached = scaleAt(latitude_e7);
        away_e7 = 0;
    }
    east_m = cached.east_m + cached.east_slope_m * static_cast<float>(away_e7);
    return cached;
}

int32_t wrappedSum_e7(int32_t longitude_e7, int32_t by_e7) {
    constexpr uint32_t kTurn_e7 = 3600000000UL;
    const uint32_t sum = static_cast<uint32_t>(longitude_e7) + static_cast<uint32_t>(by_e7);
    // Beyond +180 the sum, taken as signed, may have wrapped: see by the direction of the step.
    if (by_e7 >= 0 && longitude_e7 > kHalfTurn_e7 - by_e7)
        return static_cast<int32_t>(sum - kTurn_e7);
    if (by_e7 < 0 && longitude_e7 < -kHalfTurn_e7 - by_e7)
        return static_cast<int32_t>(sum + kTurn_e7);
    return static_cast<int32_t>(sum);
}

float squaredLength(const Offset& offset) {
    return core::squaredLength(offset.north_m, offset.east_m);
}

}  // namespace

// The difference of two longitudes can be 360 degrees, more than an
// int32_t holds.
int32_t eastward_e7(int32_t from_e7, int32_t to_e7) {
    constexpr uint32_t kTurn_e7 = 3600000000UL;
    uint32_t difference = static_cast<uint32_t>(to_e7) - static_cast<uint32_t>(from_e7);
    if (to_e7 >= from_e7) {
        if (difference > static_cast<uint32_t>(kHalfTurn_e7)) difference -= kTurn_e7;
    } else if (0 - difference > static_cast<uint32_t>(kHalfTurn_e7)) {
        difference += kTurn_e7;
    }
    return static_cast<int32_t>(difference);
}

// Middle-latitude sailing, turned from the frame of the middle into that of `from`: on the way to
// the middle the meridians turn by half their convergence.
Offset offset(const Position& from, const Position& to) {
    const int32_t up_e7 = to.latitude_e7 - from.latitude_e7;
    float east_m_per_e7;
    const Scale& scale = scaleFor(from.latitude_e7 + up_e7 / 2, east_m_per_e7);
    const float north_m = static_cast<float>(up_e7) * scale.north_m;
    const float east_m =
        static_cast<float>(eastward_e7(from.longitude_e7, to.longitude_e7)) * east_m_per_e7;
    const float turn = east_m * scale.convergence_per_m;
    return {north_m + east_m * turn, east_m - north_m * turn};
}

Position moved(const Position& from, const Offset& by) {
    float east_m_per_e7;
    // Where the middle is is known well enough without the meridians' turn.
    const Scale& start = scaleFor(from.latitude_e7, east_m_per_e7);
    const int32_t half_up_e7 = core::rounded(core::half(by.north_m) / start.north_m);
    const Scale& scale = scaleFor(from.latitude_e7 + half_up_e7, east_m_per_e7);
    const float turn = by.east_m * scale.convergence_per_m;
    const float north_m = by.north_m - by.east_m * turn;
    const float east_m = by.east_m + by.north_m * turn;
    Position to;
    to.latitude_e7 = core::limit<int32_t>(from.latitude_e7 + core::rounded(north_m / scale.north_m),
                                          -kPole_e7, kPole_e7);
    const float east_e7 = core::limit(east_m / east_m_per_e7, -1.79e9f, 1.79e9f);
    to.longitude_e7 = wrappedSum_e7(from.longitude_e7, core::rounded(east_e7));
    return to;
}

float length_m(const Offset& offset) { return sqrtf(squaredLength(offset)); }

float distance_m(const Position& from, const Position& to) { return length_m(offset(from, to)); }

float bearing_rad(const Offset& offset) {
    if (core::isZero(offset.north_m) && core::isZero(offset.east_m)) return 0;
    return atan2f(offset.east_m, offset.north_m);
}

int32_t bearing_cd(const Position& from, const Position& to) {
    return core::wrap360_cd(core::rounded(core::centidegrees(bearing_rad(offset(from, to)))));
}

Track track(const Position& leg_start, const Position& leg_end, const Position& place) {
    const Offset leg = offset(leg_start, leg_end);
    const Offset way = offset(leg_start, place);
    const float length = length_m(leg);
    if (length < 0.01f) return {0, length_m(way)};
    const float share = core::inverse(length);
    return {(way.north_m * leg.north_m + way.east_m * leg.east_m) * share,
            (way.east_m * leg.north_m - way.north_m * leg.east_m) * share};
}

bool passed(const Position& leg_start, const Position& leg_end, const Position& place) {
    const Offset leg = offset(leg_end, leg_start);  // seen from the end, back along the leg
    const Offset way = offset(leg_end, place);
    return !core::isPositive(way.north_m * leg.north_m + way.east_m * leg.east_m);
}

}  // namespace geo
