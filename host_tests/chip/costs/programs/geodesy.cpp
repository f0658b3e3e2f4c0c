// SPDX-License-Identifier: GPL-3.0-or-later
// geo/position beside what one writes first: floats of degrees on an equirectangular map. Every
// place is read from memory the compiler knows nothing of.
#include <math.h>

#include "core/maths.hpp"
#include "geo/position.hpp"
#include "steps.hpp"

namespace hal {
bool imuDataReady() { return false; }
}  // namespace hal

namespace {

volatile int32_t places[][2] = {
    {473977000, 85456000}, {474012499, 85436971}, {473990000, 85450000}};
volatile int32_t far_places[][2] = {{373977000, 85456000}, {374012499, 85436971}};
volatile float kept;
volatile bool result_bool;
volatile int32_t result_cd;

geo::Position place(volatile int32_t (&at)[2]) { return {at[0], at[1]}; }

struct Degrees {
    float latitude, longitude;
};
Degrees degrees(volatile int32_t (&at)[2]) {
    return {static_cast<float>(at[0]) * 1e-7f, static_cast<float>(at[1]) * 1e-7f};
}

// ---- the naive way
constexpr float kRadius_m = 6371000.0f;
geo::Offset naiveOffset(const Degrees& from, const Degrees& to) {
    const float middle_rad = core::radians((from.latitude + to.latitude) * 0.5f);
    return {core::radians(to.latitude - from.latitude) * kRadius_m,
            core::radians(to.longitude - from.longitude) * kRadius_m * cosf(middle_rad)};
}
float naiveDistance_m(const Degrees& from, const Degrees& to) {
    const geo::Offset way = naiveOffset(from, to);
    return sqrtf(way.north_m * way.north_m + way.east_m * way.east_m);
}
float naiveBearing_deg(const Degrees& from, const Degrees& to) {
    const geo::Offset way = naiveOffset(from, to);
    return atan2f(way.east_m, way.north_m) * (180.0f / core::kPi);
}
geo::Track naiveTrack(const Degrees& start, const Degrees& end, const Degrees& here) {
    const geo::Offset leg = naiveOffset(start, end), way = naiveOffset(start, here);
    const float length = sqrtf(leg.north_m * leg.north_m + leg.east_m * leg.east_m);
    return {(way.north_m * leg.north_m + way.east_m * leg.east_m) / length,
            (way.east_m * leg.north_m - way.north_m * leg.east_m) / length};
}
bool naivePassed(const Degrees& start, const Degrees& end, const Degrees& here) {
    const geo::Offset leg = naiveOffset(end, start), way = naiveOffset(end, here);
    return way.north_m * leg.north_m + way.east_m * leg.east_m <= 0;
}

void keep(const geo::Offset& offset) {
    kept = offset.north_m;
    kept = offset.east_m;
}
void keep(const geo::Track& track) {
    kept = track.along_m;
    kept = track.cross_m;
}

}  // namespace

int main() {
    const auto a = [] { return place(places[0]); };
    const auto b = [] { return place(places[1]); };
    const auto c = [] { return place(places[2]); };
    const auto da = [] { return degrees(places[0]); };
    const auto db = [] { return degrees(places[1]); };
    const auto dc = [] { return degrees(places[2]); };
    hal::trace(hal::kTraceFrameBegin);  // without frames nothing is measured
    costs::timed(costs::kNothing, [] {});
    costs::timed(costs::kNewBand,
                 [] { kept = geo::distance_m(place(far_places[0]), place(far_places[1])); });
    kept = geo::distance_m(a(), b());
    costs::timed(costs::kDistance, [=] { kept = geo::distance_m(a(), b()); });
    costs::timed(costs::kBearing, [=] { result_cd = geo::bearing_cd(a(), b()); });
    costs::timed(costs::kOffset, [=] { keep(geo::offset(a(), b())); });
    costs::timed(costs::kTrack, [=] { keep(geo::track(a(), b(), c())); });
    costs::timed(costs::kPassed, [=] { result_bool = geo::passed(a(), b(), c()); });
    costs::timed(costs::kNaiveDistance, [=] { kept = naiveDistance_m(da(), db()); });
    costs::timed(costs::kNaiveBearing, [=] { kept = naiveBearing_deg(da(), db()); });
    costs::timed(costs::kNaiveOffset, [=] { keep(naiveOffset(da(), db())); });
    costs::timed(costs::kNaiveTrack, [=] { keep(naiveTrack(da(), db(), dc())); });
    costs::timed(costs::kNaivePassed, [=] { result_bool = naivePassed(da(), db(), dc()); });
    for (;;) {
    }
}
