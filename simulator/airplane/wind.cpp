// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/airplane/wind.hpp"

#include <algorithm>

namespace simulator {
namespace {

constexpr double kReference_m = 10, kRoughness_m = 0.03;  // short grass
constexpr double kFeet = 0.3048;
// The forms hold from 10 to 1,000 ft; at 1,000 ft the gusts are as strong in every direction.
constexpr double kLowest_ft = 10, kHighest_ft = 1000;
constexpr double kSlowest_mps = 3;  // the filters are in terms of distance flown

}  // namespace

Vec3 meanWind_mps(double wind_mps, double from_deg, double height_m) {
    if (wind_mps == 0) return {};
    const double within = std::clamp(height_m, kRoughness_m, kReference_m);
    static const double full = std::log(kReference_m / kRoughness_m);
    const double here_mps =
        within == kReference_m ? wind_mps : wind_mps * std::log(within / kRoughness_m) / full;
    const double from = from_deg * M_PI / 180;
    return {-here_mps * std::cos(from), -here_mps * std::sin(from), 0};
}

Thermals::Thermals(double strength_mps, uint64_t seed) : strength_mps_(strength_mps) {
    constexpr double kShortest_m = 250, kLongest_m = 600;  // from one thermal to the next
    Random random(seed, 15);
    const auto wave_m = [&random] {
        return kShortest_m + (kLongest_m - kShortest_m) * random.uniform();
    };
    north_wave_m_ = wave_m();
    east_wave_m_ = wave_m();
    north_phase_ = 2 * M_PI * random.uniform();
    east_phase_ = 2 * M_PI * random.uniform();
}

double Thermals::rise_mps(double north_m, double east_m, double height_m) const {
    constexpr double kWhole_m = 60;
    if (strength_mps_ == 0) return 0;
    return strength_mps_ * std::clamp(height_m / kWhole_m, 0.0, 1.0) *
           std::sin(2 * M_PI * north_m / north_wave_m_ + north_phase_) *
           std::sin(2 * M_PI * east_m / east_wave_m_ + east_phase_);
}

Dryden::Dryden(double deviation_mps, double span_m, uint64_t seed)
    : deviation_mps_(deviation_mps), span_m_(span_m), random_(seed, 6) {}

// The second lag has half the first's variance, and half of it in common.
Dryden::Lags::Lags(Random& random)
    : first(random.normal()), second(0.5 * first + 0.5 * random.normal()) {}

// Both lags together give the spectrum of the standard's second-order forms:
// (1 + sqrt(3) T s) / (1 + T s)^2 = sqrt(3) / (1 + T s) + (1 - sqrt(3)) / (1 + T s)^2.
void Dryden::Lags::advance(double dt_s, double time_s, Random& random) {
    const double decay = std::exp(-dt_s / time_s);
    second = decay * (second + first * dt_s / time_s);
    first = decay * first + std::sqrt(1 - decay * decay) * random.normal();
}

const Gust& Dryden::advance(double dt_s, double airspeed_mps, double height_m) {
    if (deviation_mps_ == 0) return gust_;
    const double speed = std::max(airspeed_mps, kSlowest_mps);
    const double height_ft = std::clamp(height_m / kFeet, kLowest_ft, kHighest_ft);
    const double ratio = 0.177 + 0.000823 * height_ft;
    const double level_m = height_ft / std::pow(ratio, 1.2) * kFeet, down_m = height_ft * kFeet;
    const double down_deviation = deviation_mps_ * std::pow(ratio, 0.4);

    forward_.advance(dt_s, level_m / speed, random_);
    right_.advance(dt_s, level_m / speed, random_);
    down_.advance(dt_s, down_m / speed, random_);
    const double root3 = std::sqrt(3.0);
    const auto shaped = [root3](const Lags& lags) {
        return (root3 * lags.first + (1 - root3) * lags.second) * M_SQRT1_2;
    };
    gust_.velocity_mps = {deviation_mps_ * forward_.first, deviation_mps_ * shaped(right_),
                          down_deviation * shaped(down_)};

    const double pitch_s = 4 * span_m_ / (M_PI * speed), yaw_s = 3 * span_m_ / (M_PI * speed);
    roll_.advance(dt_s, pitch_s, random_);
    // The integral of the standard's roll-gust spectrum over all wave lengths.
    const double roll_deviation =
        down_deviation * std::sqrt(0.4 * M_PI / down_m * M_PI / (4 * span_m_) *
                                   std::cbrt(M_PI * down_m / (4 * span_m_)));
    down_lag_ += (gust_.velocity_mps.z - down_lag_) * (1 - std::exp(-dt_s / pitch_s));
    right_lag_ += (gust_.velocity_mps.y - right_lag_) * (1 - std::exp(-dt_s / yaw_s));
    gust_.rates_rads = {roll_deviation * roll_.first,
                        (gust_.velocity_mps.z - down_lag_) / (pitch_s * speed),
                        -(gust_.velocity_mps.y - right_lag_) / (yaw_s * speed)};
    return gust_;
}

}  // namespace simulator
