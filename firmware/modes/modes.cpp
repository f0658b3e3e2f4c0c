// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/modes/modes.hpp"

#include "core/file_state.hpp"
#include "core/rom.hpp"
#include "firmware/modes/mode_requests.hpp"
#include "firmware/modes/modes_table.hpp"
#include "firmware/modes/sticks.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/published.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<ModeState> : Writable<ModeState> {
    using Writable::state;
};
}  // namespace state

namespace modes {

using namespace notify;
using namespace state;

namespace {

constexpr ModeState& published = Publisher<ModeState>::state();

using Start = EntryResult (*)();
using Run = void (*)();

struct ModeRow {
    Mode mode;
    Start start;
    Run run;
    Run demand;
    Run stop;
};

void nothing() {}

// clang-format off
constexpr ModeRow kModes[] ROM = {
    {Mode::manual,    startManual,    runManual,    nothing,      nothing},
    {Mode::circle,    startCircle,    runCircle,    nothing,      nothing},
    {Mode::stabilize, startStabilize, runStabilize, nothing,      nothing},
    {Mode::training,  startTraining,  runTraining,  nothing,      nothing},
    {Mode::acro,      startAcro,      runAcro,      nothing,      nothing},
    {Mode::fbwa,      startFbwa,      runFbwa,      nothing,      nothing},
    {Mode::fbwb,      startFbwb,      runFbwb,      demandFbwb,   nothing},
    {Mode::cruise,    startCruise,    runCruise,    demandCruise, nothing},
    {Mode::autotune,  startAutotune,  runFbwa,      nothing,      nothing},
    {Mode::automatic, startAuto,      runAuto,      nothing,      stopAuto},
    {Mode::rtl,       startRtl,       runRtl,       nothing,      nothing},
    {Mode::loiter,    startLoiter,    runLoiter,    nothing,      nothing},
    {Mode::takeoff,   startTakeoff,   runTakeoff,   demandTakeoff, nothing},
    {Mode::guided,    startGuided,    runGuided,    nothing,      nothing},
};
// clang-format on

constexpr uint8_t kNoRow = 0xFF;
struct PresentMode {
    uint8_t row = kNoRow;
};
core::FileState<PresentMode> present{};

uint8_t find(Mode mode) {
    for (uint8_t i = 0; i < core::count(kModes); ++i)
        if (core::romRead(kModes[i].mode) == mode) return i;
    return kNoRow;
}

void reportRefusal(const ModeSituation& now) {
    sendStatusText(Severity::warning, now.resuming      ? STATUS_TEXT("Mode refused: restarting")
                                      : now.no_attitude ? STATUS_TEXT("Mode refused: no attitude")
                                                        : STATUS_TEXT("Mode refused: no radio"));
}

}  // namespace

void startModes() {
    present.row = kNoRow;
    published.mode = Mode::initialising;
}

bool requestMode(Mode mode, ModeReason reason) {
    if (vehicle.terminated) return false;
    if (present.row != kNoRow && mode == vehicle.mode) return true;
    uint8_t wanted = find(mode);
    if (wanted == kNoRow) {
        sendStatusText(Severity::warning, STATUS_TEXT("No such mode: #"),
                       static_cast<uint8_t>(mode));
        return false;
    }
    const ModeSituation now = modeSituation();
    if (!mayEnter(mode, reason, now)) {
        reportRefusal(now);
        return false;
    }
    EntryResult entry = core::romRead(kModes[wanted].start)();
    if (entry == EntryResult::home_instead) {
        wanted = find(Mode::rtl);
        entry = core::romRead(kModes[wanted].start)();
    }
    if (entry != EntryResult::entered) return false;
    if (present.row != kNoRow) core::romRead(kModes[present.row].stop)();
    present.row = wanted;
    published.mode = core::romRead(kModes[wanted].mode);
    published.mode_reason = reason;
    useSticks(Sticks::nothing);
    ++published.mode_entries;
    if (reason == ModeReason::failsafe)
        sendStatusText(Severity::warning, STATUS_TEXT("Failsafe: mode #"),
                       static_cast<uint8_t>(mode));
    return true;
}

void runMode() {
    if (present.row != kNoRow) core::romRead(kModes[present.row].run)();
}

void demandOfMode() {
    if (present.row != kNoRow) core::romRead(kModes[present.row].demand)();
}

}  // namespace modes
}  // namespace firmware
