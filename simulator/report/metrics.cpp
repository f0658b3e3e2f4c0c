// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/metrics.hpp"

#include <algorithm>
#include <cmath>

namespace simulator {

using mavlink::MavCmd;

constexpr double kCapture_s = 5, kLooseCapture_s = 15;
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
    from_ = nav_ && nav_->from ? *nav_->from : place;
}

Planned Metrics::sample(double time_s, const Truth& truth, const Point& place, int item) {
    const int flown = nav_ ? nav_->item : 0;
    if (item != flown) begin(time_s, place, item);
    Planned planned;
    if (!nav_ || !nav_->place || truth.on_ground) return planned;
    const bool circle = mavlink::MavCmd::nav_loiter_unlim <= nav_->command &&
                        nav_->command <= MavCmd::nav_loiter_time;
    const bool loose = circle || nav_->from_circle;
    planned.counts = time_s - begun_s_ >= (loose ? kLooseCapture_s : kCapture_s);
    planned.airspeed_mps = nav_->airspeed_mps ? nav_->airspeed_mps : cruise_speed_mps_;
    if (circle) {
        judgeCircle(planned);
    } else {
        judgeStraight(planned, truth, place);
    }
    if (planned.counts && nav_->command != MavCmd::nav_land) {
        if (planned.height_m) altitude.add(truth.height_m - *planned.height_m);
        if (planned.airspeed_mps) {
            airspeed.add(truth.equivalent_airspeed_mps - *planned.airspeed_mps);
        }
    }
    return planned;
}

void Metrics::judgeCircle(Planned& planned) const { planned.height_m = nav_->height_m; }

void Metrics::judgeStraight(Planned& planned, const Truth& truth, const Point& place) {
    planned.height_m = Plan::height_m(*nav_, from_, place);
    planned.crosstrack_m = along(from_, *nav_->place, place).across_m;
    const bool flares = nav_->command == MavCmd::nav_land && truth.height_m < kFlare_m;
    if (planned.counts && !flares) crosstrack.add(*planned.crosstrack_m);
}

}  // namespace simulator
