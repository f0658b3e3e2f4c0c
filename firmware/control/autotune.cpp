// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/control/autotune.hpp"

#include <math.h>

#include "control/tuner.hpp"
#include "core/based.hpp"
#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "core/rom.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace control {

using namespace notify;
using namespace state;

namespace {

using ::control::AxisTuner;

enum Gain : uint8_t { kTimeConstant, kP, kI, kD, kGains };  // as their slots follow one another

struct Axis {
    uint8_t slots;  // the first one's
    TextField<16> found;
};
constexpr Axis kAxes[] ROM = {{101, "Autotune: roll # %"}, {107, "Autotune: pitch # %"}};

struct Tuners {
    AxisTuner tuners[core::count(kAxes)];
};
core::FileState<Tuners> tuning{};

// _TCONST for AUTOTUNE_LEVEL 1 .. 10, 1/100 s
constexpr uint8_t kTimeConstants[] ROM = {80, 70, 60, 52, 45, 40, 35, 30, 25, 20};

// Of a small airplane that full aileron rolls at 10 rad/s, and where the parameters end. With less,
// gusts turn it more than its surfaces do, and what they do is measured. A gain that is there
// stays.
constexpr float kLeastP = 0.2f, kMaxP = 4.0f;

constexpr uint8_t kLeveled = 2 * core::count(kAxes);

// What is still to be set, a parameter each time: finding one by its slot takes long.
struct DueChanges {
    uint8_t level = kLeveled;  // of each axis first P, then the time constant; kLeveled: none
    uint8_t gain = kGains;     // kP .. kD of this axis; kGains: none
    uint8_t axis;
    float by = 1;
};
core::FileState<DueChanges> due{};

const ::control::AxisSettings& settingsOf(uint8_t axis) {
    return axis == kTunedRoll ? parameters.roll.axis : parameters.pitch.axis;
}

bool set(uint8_t axis, uint8_t gain, float value) {
    return parameterSet(static_cast<uint8_t>(core::romRead(kAxes[axis].slots) + gain), value);
}

// The surface for a rate, (P - I T) T - D, stays what it is.
void setLevel() {
    const uint8_t axis = due.level / 2;
    const ::control::AxisSettings& now = settingsOf(axis);
    const float time_constant_s =
        core::hundredths(int16_t{core::romRead(kTimeConstants[parameters.autotune_level - 1])});
    if (due.level % 2 == 0 && fabsf(now.time_constant_s - time_constant_s) < 0.001f)
        return (void)(due.level += 2);  // it is what it shall be: nothing is rounded and stored
    const bool last = due.level++ % 2 != 0;
    if (last) return (void)set(axis, kTimeConstant, time_constant_s);
    const float direct = (now.p - now.i * now.time_constant_s) * now.time_constant_s;
    if (!set(axis, kP, direct / time_constant_s + now.i * time_constant_s)) ++due.level;
}

// P comes first and is the first to end at its range; the others keep its proportions.
void setGain() {
    const ::control::AxisSettings& now = settingsOf(due.axis);
    const float gain = due.gain == kP ? now.p : (due.gain == kI ? now.i : now.d);
    due.gain = set(due.axis, due.gain, gain * due.by) ? due.gain + 1 : kGains;
}

void change(uint8_t axis, float by) {
    const float p = fmaxf(settingsOf(axis).p, kLeastP);
    due.by = core::limit(p * by, kLeastP, kMaxP) / p;
    due.axis = axis;
    due.gain = kP;
    sendStatusText(Severity::info, kAxes[axis].found,
                   static_cast<uint16_t>(core::inHundredths(due.by)));
}

}  // namespace

void startTuning() {
    for (AxisTuner& tuner : tuning.tuners) tuner = AxisTuner();
    due.gain = kGains;
    due.level = parameters.autotune_level == 0 ? kLeveled : 0;
}

void tuneStep() {
    if (vehicle.mode != Mode::autotune) return;
    if (due.level < kLeveled)
        setLevel();
    else if (due.gain < kGains)
        setGain();
}

void tune(TunedAxis which, const ::control::AxisGains& gains, const ::control::AxisState& state,
          const ::control::AirFlow& air, core::Angle error_rad, core::BodyRate rate_rads,
          ::control::Swing& swing) {
    constexpr core::Ratio kLevel_cos(0.94f);
    AxisTuner& tuner = core::based(tuning.tuners[which]);
    // in a bank the nose turns without the pilot's asking for it
    if (which == kTunedPitch && vehicle.attitude.cos_roll.raw < kLevel_cos.raw) return tuner.drop();
    const auto found = tuner.watch(
        gains, state, air, ::control::demandedRate_rads(gains, error_rad), rate_rads, swing);
    if (found == AxisTuner::Finding::nothing || due.gain < kGains) return;
    change(which, found == AxisTuner::Finding::shakes ? AxisTuner::kLeast : tuner.factor());
}

bool tuneTo(TunedAxis which, uint8_t left_pct) {
    if (due.level < kLeveled || due.gain < kGains) return false;
    change(which, core::hundredths(int16_t{left_pct}));
    return true;
}

}  // namespace control
}  // namespace firmware
