// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/control/oscillation.hpp"

#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "core/rom.hpp"
#include "core/seldom.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace control {

using namespace notify;
using namespace state;

namespace {

using ::control::kWeakened;

struct AxisText {
    TextField<22> oscillates;
};
constexpr AxisText kAxes[] ROM = {{"Roll oscillates: gains # %"}, {"Pitch oscillates: gains # %"}};

struct Oscillations {
    ::control::Swing swings[core::count(kAxes)];
    uint8_t weakened[core::count(kAxes)];  // how many times the gains have been
};
core::FileState<Oscillations> oscillations{};

// What is left of gains that have been weakened so many times.
constexpr uint8_t kLeft_pct[] ROM = {100, static_cast<uint8_t>(100 * kWeakened),
                                     static_cast<uint8_t>(100 * kWeakened * kWeakened),
                                     static_cast<uint8_t>(100 * kWeakened * kWeakened * kWeakened)};
uint8_t leftOf_pct(TunedAxis axis) { return core::romRead(kLeft_pct[oscillations.weakened[axis]]); }

// Not what the pilot's stick may swing.
bool stirred(int16_t stick_cd) {
    constexpr int16_t kStirred_cd = 450;
    return stick_cd > kStirred_cd || stick_cd < -kStirred_cd;
}

SELDOM bool weakenOnce(TunedAxis axis) {
    uint8_t& times = oscillations.weakened[axis];
    if (times + 1u >= core::count(kLeft_pct)) return false;
    ++times;
    sendStatusText(Severity::warning, kAxes[axis].oscillates, leftOf_pct(axis));
    return true;
}

}  // namespace

::control::Swing& swingOf(TunedAxis axis) { return oscillations.swings[axis]; }

bool oscillates(TunedAxis axis, core::BodyRate rate_rads, core::Ratio surface, int16_t stick_cd) {
    constexpr ::control::Swing::Limits kSwings = {4, 18, 12};  // to and fro twice; in runs of 50 ms
    if (stirred(stick_cd) || !swingOf(axis).watch(rate_rads, surface, kSwings)) return false;
    return weakenOnce(axis);
}

void weakenAsBefore(TunedAxis axis, ::control::AxisGains& gains) {
    for (uint8_t i = 0; i < oscillations.weakened[axis]; ++i) ::control::weaken(gains);
}

bool weaknessEnds(TunedAxis axis) {
    uint8_t& times = oscillations.weakened[axis];
    if (times == 0) return false;
    // the loop keeps weak gains until AUTOTUNE has set the first of them
    const bool tuned = vehicle.mode == Mode::autotune && tuneTo(axis, leftOf_pct(axis));
    if (vehicle.armed && !tuned) return false;
    times = 0;
    return !tuned;
}

}  // namespace control
}  // namespace firmware
