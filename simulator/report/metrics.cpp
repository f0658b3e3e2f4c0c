// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/metrics.hpp"

#include <algorithm>
#include <cmath>

namespace simulator {

using mavlink::MavCmd;

constexpr double kCapture_s = 5, kLooseCapture_s = 15, kSettle_s = 5;
constexpr double kLevel_m = 1, kNearCircle = 1.1;
constexpr double kFlare_m = 5;

void Spread::add(double error) {
    squares_ += error * error;
    max_ = std::max(max_, std::abs(error));
    ++count_;
}

std::optional<double> Spread::rms() const {
    if (count_ == 0) return std::nullopt;
    return std::sqrt(squares_ / static_cast<double>(count_));
}

std::optional<double> Spread::max() const {
    if (count_ == 0) return std::nullopt;
    return max_;
}

void Metrics::begin(double time_s, const Point& place, int item) {
    nav_ = plan_.nav(item);
    begun_s_ = time_s;
    circling_s_.reset();
    from_ = nav_ && nav_->from ? *nav_->from : place;
}

Planned Metrics::sample(double time_s, const Truth& truth, const Point& place, int item) {
    const int flown = nav_ ? nav_->item : 0;
    if (item != flown) begin(time_s, place, item);
    Planned planned;
    if (!nav_ || !nav_->place || truth.on_ground) return planned;
    if (truth.height_m >= kFlare_m) {
        const double now_mps = truth.equivalent_airspeed_mps;
        slowest_mps = std::min(slowest_mps.value_or(now_mps), now_mps);
    }
    const bool circle = mavlink::MavCmd::nav_loiter_unlim <= nav_->command &&
                        nav_->command <= MavCmd::nav_loiter_time;
    const bool loose = circle || nav_->from_circle;
    const double captured_s = time_s - begun_s_ - (loose ? kLooseCapture_s : kCapture_s);
    planned.counts = captured_s >= 0;
    planned.airspeed_mps = nav_->airspeed_mps ? nav_->airspeed_mps : cruise_speed_mps_;
    if (circle) {
        measureCircle(planned, place, time_s);
    } else {
        measureStraight(planned, truth, place, captured_s);
    }
    if (planned.counts && nav_->command != MavCmd::nav_land) {
        if (planned.height_m) measureHeight(truth.height_m - *planned.height_m);
        if (planned.airspeed_mps) {
            airspeed.add(truth.equivalent_airspeed_mps - *planned.airspeed_mps);
        }
    }
    return planned;
}

void Metrics::measureHeight(double error_m) {
    altitude.add(error_m);
    const bool flat = nav_->circle_m || std::abs(nav_->height_m - nav_->from_height_m) < kLevel_m;
    (flat ? level : sloped).add(error_m);
}

void Metrics::measureCircle(Planned& planned, const Point& place, double time_s) {
    planned.height_m = nav_->height_m + home_height_m_;
    const double given_m = std::abs(nav_->circle_m.value_or(0));
    const double radius_m = given_m > 0 ? given_m : std::abs(loiter_radius_m_.value_or(0));
    if (radius_m <= 0) return;
    const double away_m = distance_m(*nav_->place, place);
    if (!circling_s_ && away_m <= kNearCircle * radius_m) circling_s_ = time_s;
    if (circling_s_ && time_s - *circling_s_ >= kCapture_s) radius.add(away_m - radius_m);
}

void Metrics::measureStraight(Planned& planned, const Truth& truth, const Point& place,
                              double captured_s) {
    planned.height_m = Plan::height_m(*nav_, from_, place) + home_height_m_;
    planned.crosstrack_m = along(from_, *nav_->place, place).across_m;
    const bool flares = nav_->command == MavCmd::nav_land && truth.height_m < kFlare_m;
    if (!planned.counts || flares) return;
    crosstrack.add(*planned.crosstrack_m);
    if (captured_s >= kSettle_s) settled.add(*planned.crosstrack_m);
}

}  // namespace simulator
