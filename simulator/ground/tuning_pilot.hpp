// SPDX-License-Identifier: GPL-3.0-or-later
// The sticks of a pilot who flies AUTOTUNE: full roll to either side, then the wings held level and
// the nose up and down. The throttle keeps the height that the elevator leaves. He stands where the
// airplane took off, and turns it back before it is too far away for its attitude to be seen.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "simulator/world.hpp"

namespace simulator {

constexpr double kTuneRolls_s = 100, kTuneAll_s = 200;  // then the nose; when he has done
constexpr uint16_t kFirstMode_us = 1165;                // the mode switch on FLTMODE1

// A pilot who knows his airplane: at `cruise_mps` it flies easily, and slower he neither banks it
// steeply nor pulls, but gives it power first.
class TuningPilot {
public:
    // A wing of 1.4 m is seen at a quarter of a degree from 300 m, half as large as the moon.
    explicit TuningPilot(double cruise_mps, double sight_m = 300)
        : cruise_mps_(cruise_mps), sight_m_(sight_m) {}

    // Channels 1 to 8, in us, `since_s` after AUTOTUNE was chosen.
    std::array<uint16_t, 8> sticks(double since_s, const Truth& truth) {
        const double speed_mps = truth.equivalent_airspeed_mps;
        const bool slow = speed_mps < 0.85 * cruise_mps_;
        const double wanted =
            0.6 + (100 - truth.height_m) * 0.02 + (cruise_mps_ - speed_mps) * 0.15;
        const double throttle_us = -400 + 800 * std::clamp(wanted, 0.2, 1.0);
        const Stick stick = turnsBack(truth)         ? turning(truth, slow)
                            : since_s < kTuneRolls_s ? rolling(since_s, truth, slow)
                                                     : pitching(since_s, truth, slow);
        return {us(stick.roll), us(stick.pitch), us(throttle_us), 1500, 1500, 1500,
                1500,           kFirstMode_us};
    }

private:
    struct Stick {
        int roll, pitch;
    };
    static uint16_t us(double by) { return static_cast<uint16_t>(1500 + by); }
    static bool other(double since_s) { return std::fmod(since_s, 6) >= 3; }
    int keepsHeight(const Truth& truth) const {
        return truth.height_m < 90 && truth.equivalent_airspeed_mps > cruise_mps_ ? 120 : 0;
    }

    Stick rolling(double since_s, const Truth& truth, bool slow) const {
        return {slow ? 0 : other(since_s) ? 400 : -400, keepsHeight(truth)};
    }
    static Stick pitching(double since_s, const Truth& truth, bool slow) {
        constexpr double kLow_m = 60;  // lower the nose is not put down
        const bool up = other(since_s) && !slow;
        return {0, up ? 350 : (truth.height_m > kLow_m ? -350 : 0)};
    }
    Stick turning(const Truth& truth, bool slow) const {
        const int bank = slow ? 200 : 400;
        return {homeward_rad(truth) > 0 ? bank : -bank, keepsHeight(truth)};
    }

    bool turnsBack(const Truth& truth) {
        constexpr double kHomeward_rad = 0.3;
        const bool far = std::hypot(truth.north_m, truth.east_m) > sight_m_;
        const double off_rad = std::abs(homeward_rad(truth));
        turns_back_ = turns_back_ ? off_rad > kHomeward_rad : far && off_rad > M_PI / 2;
        return turns_back_;
    }
    // From the course to where he stands, to the right.
    static double homeward_rad(const Truth& truth) {
        const double course_rad = std::atan2(truth.velocity_east_mps, truth.velocity_north_mps);
        const double home_rad = std::atan2(-truth.east_m, -truth.north_m);
        return std::remainder(home_rad - course_rad, 2 * M_PI);
    }

    double cruise_mps_, sight_m_;
    bool turns_back_ = false;
};

}  // namespace simulator
