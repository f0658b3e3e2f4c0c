// SPDX-License-Identifier: GPL-3.0-or-later
// The flight model under lateral guidance at 20 Hz, seen through the errors of an estimator.
#pragma once
#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <random>

#include "flight_model.hpp"
#include "navigation/l1.hpp"

namespace flight_model {

constexpr geo::Position kOrigin{473977000, 85456000};

struct Statistics {
    double sum2 = 0, worst = 0;
    int count = 0;
    void add(double error) {
        sum2 += error * error;
        worst = std::max(worst, std::fabs(error));
        ++count;
    }
    double rms() const { return count ? std::sqrt(sum2 / count) : 0; }
};

inline geo::Position at(double north_m, double east_m) {
    return geo::moved(kOrigin, {static_cast<float>(north_m), static_cast<float>(east_m)});
}

class Pilot {
public:
    using Law = std::function<navigation::Lateral(const navigation::Motion&, const geo::Position&)>;

    explicit Pilot(const Wind& wind = {}) : plane(wind), wind_(wind), noise_(wind.seed + 100) {
        plane.height = 100;
    }

    // As an estimator gives it.
    geo::Position place() {
        std::normal_distribution<double> normal;
        const auto jitter = [&](double sigma) { return errors ? sigma * normal(noise_) : 0; };
        return at(plane.north + jitter(0.1), plane.east + jitter(0.1));
    }

    navigation::Motion motion() {
        std::normal_distribution<double> normal;
        const auto jitter = [&](double sigma) { return errors ? sigma * normal(noise_) : 0; };
        navigation::Motion m{};
        m.airspeed_mps = static_cast<float>(plane.airspeed);
        m.velocity_mps = {static_cast<float>(plane.velocity_n + jitter(0.08)),
                          static_cast<float>(plane.velocity_e + jitter(0.08))};
        m.wind_mps = {static_cast<float>(wind_.north_mps), static_cast<float>(wind_.east_mps)};
        m.bank_accel_mss = static_cast<float>(9.80665 * std::tan(plane.roll + jitter(0.008)));
        m.bank_lag_s = 0.6f;
        return m;
    }

    // Flies `law` for so long, or until `each` says enough.
    void fly(double seconds, const Law& law,
             const std::function<bool(const navigation::Lateral&)>& each) {
        for (double end = time + seconds; time < end;) {
            const auto lateral = law(motion(), place());
            const double limit = 45 * 3.14159265 / 180;
            plane.roll_demand =
                std::clamp<double>(navigation::bankFor_rad(lateral.bank_accel_mss), -limit, limit);
            banks.add(plane.roll_demand - plane.roll);
            holdHeightAndSpeed();
            for (int i = 0; i < 10; ++i) plane.step(0.005);
            time += 0.05;
            if (!each(lateral)) return;
        }
    }

    Airplane plane;
    bool errors = true;
    double time = 0;
    Statistics banks;

private:
    // good enough that only the lateral law is on trial
    void holdHeightAndSpeed() {
        plane.throttle = std::clamp(0.42 + 0.15 * (12.5 - plane.airspeed), 0.0, 1.0);
        integral_ = std::clamp(integral_ + 0.0005 * (100 - plane.height), -0.2, 0.2);
        plane.pitch_demand = std::clamp(
            0.05 + integral_ + 0.04 * (100 - plane.height) - 0.06 * plane.climb, -0.4, 0.4);
    }

    Wind wind_;
    std::mt19937 noise_;
    double integral_ = 0;
};

}  // namespace flight_model
