// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/modes/modes.hpp"

#include "core/rom.hpp"
#include "firmware/modes/modes_table.hpp"
#include "firmware/notify/status_text.hpp"

namespace firmware {
namespace modes {

using namespace notify;
using namespace state;

namespace {

using Start = Entry (*)();
using Run = void (*)();

enum class Throttle : uint8_t { pilot, automatic, speed };  // speed: as the stick asks for
enum class Guidance : uint8_t { none, height, path };       // what guidance.cpp flies of the demand

struct ModeRow {
    Mode mode;
    Throttle throttle;
    Guidance guidance;
    Start start;
    Run run;
    Run demand;
    Run stop;
};

void nothing() {}

// clang-format off
constexpr ModeRow kModes[] ROM = {
    {Mode::manual,    Throttle::pilot,     Guidance::none,   startManual,    runManual,    nothing,      nothing},
    {Mode::circle,    Throttle::automatic, Guidance::height, startCircle,    runCircle,    nothing,      nothing},
    {Mode::stabilize, Throttle::pilot,     Guidance::none,   startStabilize, runStabilize, nothing,      nothing},
    {Mode::training,  Throttle::pilot,     Guidance::none,   startTraining,  runTraining,  nothing,      nothing},
    {Mode::acro,      Throttle::pilot,     Guidance::none,   startAcro,      runAcro,      nothing,      nothing},
    {Mode::fbwa,      Throttle::pilot,     Guidance::none,   startFbwa,      runFbwa,      nothing,      nothing},
    {Mode::fbwb,      Throttle::speed,     Guidance::height, startFbwb,      runFbwb,      demandFbwb,   nothing},
    {Mode::cruise,    Throttle::speed,     Guidance::path,   startCruise,    runCruise,    demandCruise, nothing},
    {Mode::autotune,  Throttle::pilot,     Guidance::none,   startAutotune,  runFbwa,      nothing,      nothing},
    {Mode::automatic, Throttle::automatic, Guidance::path,   startAuto,      runAuto,      nothing,      stopAuto},
    {Mode::rtl,       Throttle::automatic, Guidance::path,   startRtl,       runRtl,       nothing,      nothing},
    {Mode::loiter,    Throttle::automatic, Guidance::path,   startLoiter,    runLoiter,    nothing,      nothing},
    {Mode::guided,    Throttle::automatic, Guidance::path,   startGuided,    runGuided,    nothing,      nothing},
};
// clang-format on

constexpr uint8_t kNoRow = 0xFF;
uint8_t row = kNoRow;

uint8_t find(Mode mode) {
    for (uint8_t i = 0; i < core::count(kModes); ++i)
        if (core::romRead(kModes[i].mode) == mode) return i;
    return kNoRow;
}

}  // namespace

bool isMode(uint8_t custom_mode) { return find(static_cast<Mode>(custom_mode)) != kNoRow; }

bool setMode(Mode mode, ModeReason reason) {
    if (row != kNoRow && mode == vehicle.mode) return true;
    uint8_t wanted = find(mode);
    if (wanted == kNoRow) {
        tell(Severity::warning, ROM_TEXT("No such mode: #"), static_cast<uint8_t>(mode));
        return false;
    }
    Entry entry = core::romRead(kModes[wanted].start)();
    if (entry == Entry::home_instead) {
        wanted = find(Mode::rtl);
        entry = core::romRead(kModes[wanted].start)();
    }
    if (entry != Entry::entered) return false;
    if (row != kNoRow) core::romRead(kModes[row].stop)();
    row = wanted;
    vehicle.mode = core::romRead(kModes[wanted].mode);
    vehicle.sticks = Sticks::nothing;
    vehicle.pilot_roll_rad = vehicle.pilot_pitch_rad = core::Angle::fromRaw(0);
    vehicle.mode_changed = true;
    if (reason == ModeReason::failsafe)
        tell(Severity::warning, ROM_TEXT("Failsafe: mode #"), static_cast<uint8_t>(mode));
    return true;
}

void runMode() {
    if (row != kNoRow) core::romRead(kModes[row].run)();
}

void demandOfMode() {
    if (row != kNoRow) core::romRead(kModes[row].demand)();
}

bool guidesItself() {
    return row != kNoRow && core::romRead(kModes[row].guidance) != Guidance::none;
}

bool autoThrottle() {
    return row != kNoRow && core::romRead(kModes[row].throttle) != Throttle::pilot;
}

bool stickSetsSpeed() {
    return row != kNoRow && core::romRead(kModes[row].throttle) == Throttle::speed;
}

}  // namespace modes
}  // namespace firmware
