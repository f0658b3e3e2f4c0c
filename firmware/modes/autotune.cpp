// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/modes/autotune.hpp"

#include "control/tuner.hpp"
#include "core/maths.hpp"
#include "core/rom.hpp"
#include "firmware/modes/modes_table.hpp"
#include "firmware/parameters.hpp"
#include "firmware/telemetry/text.hpp"
#include "firmware/vehicle.hpp"

namespace firmware {
namespace {

using control::AxisTuner;

enum Gain : uint8_t { kTimeConstant, kP, kI, kD, kGains };  // as their slots follow one another

struct Axis {
    uint8_t slots;  // the first one's
    core::RomText found;
};
constexpr char kRollFound[] ROM = "Autotune: roll # %";
constexpr char kPitchFound[] ROM = "Autotune: pitch # %";
constexpr Axis kAxes[] ROM = {{101, kRollFound}, {107, kPitchFound}};

AxisTuner tuners[core::count(kAxes)];

// _TCONST for AUTOTUNE_LEVEL 1 .. 10, 1/100 s
constexpr uint8_t kTimeConstants[] ROM = {80, 70, 60, 52, 45, 40, 35, 30, 25, 20};

void read(uint8_t slots, float (&gains)[kGains]) {
    for (float& each : gains) (void)parameterGet(slots++, each);
}

// All of them or none: their proportions are the loop's shape.
void write(uint8_t slots, const float (&gains)[kGains]) {
    for (uint8_t i = 0; i < kGains; ++i)
        if (!parameterSlotTakes(static_cast<uint8_t>(slots + i), gains[i])) return;
    for (float each : gains) (void)parameterSet(slots++, each);
}

// The surface for a rate, (P - I T) T - D, stays what it is.
void setTimeConstant(uint8_t slots, float time_constant_s) {
    float gains[kGains];
    read(slots, gains);
    const float direct = (gains[kP] - gains[kI] * gains[kTimeConstant]) * gains[kTimeConstant];
    gains[kTimeConstant] = time_constant_s;
    gains[kP] = direct / time_constant_s + gains[kI] * time_constant_s;
    write(slots, gains);
}

__attribute__((noinline)) void scale(const Axis& axis, float by) {
    float gains[kGains];
    read(axis.slots, gains);
    for (uint8_t i = kP; i < kGains; ++i) gains[i] *= by;
    write(axis.slots, gains);
    tell(Severity::info, axis.found, static_cast<uint16_t>(core::rounded(by * 100)));
}

}  // namespace

Entry startAutotune() {
    for (AxisTuner& tuner : tuners) tuner = AxisTuner();
    if (parameters.autotune_level == 0) return Entry::entered;
    const uint8_t time_constant_cs = core::romRead(kTimeConstants[parameters.autotune_level - 1]);
    for (const Axis& axis : kAxes)
        setTimeConstant(core::romRead(axis.slots), time_constant_cs * 0.01f);
    return Entry::entered;
}

void tune(TunedAxis which, const control::AxisGains& gains, const control::AxisState& state,
          const control::AirFlow& air, core::Angle error_rad, core::Fixed<10> rate_rads) {
    constexpr core::Fixed<14> kLevel_cos = 0.94f;
    AxisTuner& tuner = tuners[which];
    // in a bank the nose turns without the pilot's asking for it
    if (which == kTunedPitch && vehicle.attitude.cos_roll.raw < kLevel_cos.raw) return tuner.drop();
    const auto found =
        tuner.watch(gains, state, air, control::demandedRate_rads(gains, error_rad), rate_rads);
    if (found == AxisTuner::Finding::nothing) return;
    scale(core::romRead(kAxes[which]),
          found == AxisTuner::Finding::shakes ? AxisTuner::kLeast : tuner.factor());
}

}  // namespace firmware
