// SPDX-License-Identifier: GPL-3.0-or-later
// Holds height and airspeed by total energy: the throttle answers for the sum of potential and
// kinetic energy, the pitch for the balance between the two (A. A. Lambregts, AIAA 83-2239).
// Energies are heights: kinetic energy V2 / 2g. A demanded slope is fed forward, and the height
// demand is shaped to what can be flown, so that neither begins with an error.
#pragma once
#include <stdint.h>

#include "control/settings.hpp"

namespace control {

struct SpeedHeightLimits {
    float pitch_min_rad, pitch_max_rad;
    float throttle_min, throttle_max, throttle_cruise;  // 0..1
    float throttle_slew;                                // a second
    float airspeed_min_mps, airspeed_max_mps;
};

struct SpeedHeightDemand {
    float height_m;
    float climb_mps;  // at which height_m itself moves
    float airspeed_mps;
};

struct SpeedHeightMeasured {
    float height_m, climb_mps;
    float airspeed_mps;      // noisy as it is, or an estimate
    float acceleration_mss;  // along the flight path
    float cos_roll;
    bool airspeed_known;  // false: the throttle follows the pitch
};

enum class Phase : uint8_t {
    cruise,
    approach,   // as cruise, but the pitch holds the height alone and the throttle the speed
    climb_out,  // all throttle; the pitch holds the speed, above pitch_min_rad
    flare,      // the pitch holds demand.climb_mps, the throttle is throttle_max
};

struct SpeedHeightOutput {
    float pitch_rad;
    float throttle;
};

// What it works with, each as it has been made of what was demanded and measured: for the log.
struct SpeedHeightFlown {
    float height_m_ = 0, climb_mps_ = 0;        // the shaped height demand
    float speed_demand_mps_ = 0;                // shaped
    float speed_mps_ = 0, speed_rate_mss_ = 0;  // filtered
    float throttle_ = 0, pitch_rad_ = 0;        // put out
    float speed_demand_rate_mss_ = 0;
};

class SpeedHeight : private SpeedHeightFlown {
public:
    // Takes over from whoever flew, without a step.
    void start(const SpeedHeightMeasured& now, float pitch_rad, float throttle);

    SpeedHeightOutput run(const SpeedHeightSettings& settings, const SpeedHeightLimits& limits,
                          const SpeedHeightDemand& demand, const SpeedHeightMeasured& now,
                          Phase phase, float dt_s);

    void shift(float by_m) { height_m_ += by_m; }  // heights are measured from elsewhere

    float heightDemand_m() const { return height_m_; }  // shaped
    float airspeed_mps() const { return speed_mps_; }   // filtered
    const SpeedHeightFlown& flown() const { return *this; }
    bool underspeed() const { return underspeed_; }

private:
    struct Errors {  // as heights and climb rates
        float potential_m, potential_mps;
        float kinetic_m, kinetic_mps;
    };
    struct Step {  // what several of the parts below would divide by
        float dt_s, rate_hz;
        float inverse_speed_spm, inverse_time_constant_hz;
    };
    void filterSpeed(const SpeedHeightSettings& settings, const SpeedHeightMeasured& now,
                     float dt_s);
    void shapeHeight(const SpeedHeightSettings& settings, const SpeedHeightDemand& demand,
                     const Step& step);
    void shapeSpeed(const SpeedHeightSettings& settings, const SpeedHeightLimits& limits,
                    float demand_mps, const Step& step);
    void watchUnderspeed(const SpeedHeightLimits& limits, Phase phase, bool airspeed_known);
    float underspeedFraction(const SpeedHeightLimits& limits, bool airspeed_known,
                             Phase phase) const;
    Errors errors(const SpeedHeightMeasured& now) const;
    float throttleForPitch(const SpeedHeightLimits& limits) const;
    float throttle(const SpeedHeightSettings& settings, const SpeedHeightLimits& limits,
                   const SpeedHeightMeasured& now, const Errors& errors, float turn,
                   const Step& step);
    float pitch(const SpeedHeightSettings& settings, const SpeedHeightLimits& limits,
                const Errors& errors, float speed_weight, float lift_rad, const Step& step);
    void beginOrEndFlare(bool flares, float lift_rad);

    float climb_rate_mss_ = 0;
    float speed_bias_mss_ = 0;
    float pitch_integral_rad_ = 0, throttle_integral_ = 0;
    bool underspeed_ = false;
    bool flaring_ = false;  // then the pitch's integral is without the angle of attack
};

}  // namespace control
