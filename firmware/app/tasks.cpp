// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/app/tasks.hpp"

#include "board.hpp"
#include "core/file_state.hpp"
#include "core/seldom.hpp"
#include "firmware/actuators/camera.hpp"
#include "firmware/actuators/flaps.hpp"
#include "firmware/actuators/lights.hpp"
#include "firmware/actuators/outputs.hpp"
#include "firmware/app/dataflash.hpp"
#include "firmware/control/attitude_control.hpp"
#include "firmware/control/autotune.hpp"
#include "firmware/control/inverted.hpp"
#include "firmware/control/stall.hpp"
#include "firmware/estimator/estimator.hpp"
#include "firmware/gcs/aux_switches.hpp"
#include "firmware/gcs/telemetry.hpp"
#include "firmware/guidance/guidance.hpp"
#include "firmware/logger/log.hpp"
#include "firmware/mission/mission.hpp"
#include "firmware/mission/rally.hpp"
#include "firmware/mission/servo_relay_events.hpp"
#include "firmware/modes/mode_switch.hpp"
#include "firmware/modes/modes.hpp"
#include "firmware/safety/arming.hpp"
#include "firmware/safety/failsafe.hpp"
#include "firmware/safety/fence.hpp"
#include "firmware/safety/restart.hpp"
#include "firmware/safety/supervisor.hpp"
#include "firmware/sensors/radio.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/processor_figures.hpp"
#include "firmware/state/vehicle.hpp"
#include "hal/clock.hpp"
#include "hal/hang_timer.hpp"
#include "hal/watchdog.hpp"
#include "scheduler/proofs.hpp"
#include "scheduler/scheduler.hpp"

namespace firmware {
namespace app {

using namespace state;
using namespace sensors;
using namespace estimator;
using namespace control;
using namespace guidance;
using namespace actuators;
using namespace mission;
using namespace modes;
using namespace safety;
using namespace logger;
using namespace gcs;

namespace {

constexpr uint16_t kFrame_us = 10000;
// The inertial sensor's clock may be 1 % slow; without its samples a frame begins by the clock.
constexpr uint16_t kSilentImu_us = 10400;

void measureLoad();

using scheduler::Tier;
constexpr Tier fast = Tier::fast;      // sticks and stabilising: never put off
constexpr Tier medium = Tier::medium;  // sensors, navigation, telemetry
constexpr Tier slow = Tier::slow;      // mode switch, log and the rest: the first to wait

}  // namespace

// The budgets are what the flights of the tests have measured and a little more; the tests hold
// each task's longest time between half its budget and all of it.
// clang-format off
#define TASKS(TASK)                                                           \
    /* tier    run                    every  in     budget */                 \
    /*                                frames frame  us */                     \
    TASK(fast,   runInertial,             1,     0,    1050)                  \
    TASK(fast,   runRadio,                1,     0,     200)                  \
    TASK(fast,   runAttitude,             1,     0,     300)                  \
    TASK(fast,   runMode,                 1,     0,     105)                  \
    TASK(fast,   runAttitudeControl,      1,     0,     340)                  \
    TASK(fast,   runOutputs,              1,     0,     150)                  \
                                                                              \
    TASK(medium, runBarometer,            1,     0,     160)                  \
    TASK(medium, gatherPressure,          1,     0,       6)                  \
    TASK(medium, runGps,                  1,     0,     530)                  \
    TASK(medium, runAirspeed,             2,     1,      85)                  \
    TASK(medium, alignAttitude,          10,     9,     610)                  \
    TASK(medium, rotateDcm,              2,     0,     280)                   \
    TASK(medium, orthonormalizeMatrix,   10,     7,     330)                  \
    TASK(medium, pointYaw,               10,     0,     105)                  \
    TASK(medium, propagateMotion,         4,     1,     590)                  \
    TASK(medium, fusePressure,            5,     3,     420)                  \
    TASK(medium, publishSpeeds,           5,     1,     290)                  \
    TASK(medium, reckonPosition,         10,     7,     250)                  \
    TASK(medium, checkEstimate,          10,     8,       8)                  \
    TASK(medium, updateFlying,           10,     6,      50)                  \
    TASK(medium, fuseFixAttitude,         5,     0,    1540)                  \
    TASK(medium, fuseFixPosition,         5,     1,    1220)                  \
    TASK(medium, fuseFixWind,             5,     1,     620)                  \
    TASK(medium, fuseFixHeight,           5,     0,     600)                  \
    TASK(medium, learnGpsDelay,           5,     4,     520)                  \
    TASK(medium, fuseCompass,            20,    11,    1260)                  \
    TASK(medium, fuseAirspeed,           20,    19,    1290)                  \
    TASK(medium, telemetrySend,           2,     0,    1100)                  \
    TASK(medium, runGuidance,             5,     2,    2050)                  \
    TASK(medium, runSpeedHeight,         10,     4,    1750)                  \
    TASK(medium, runSpeedScaling,         5,     4,     160)                  \
    TASK(medium, runRestart,              2,     1,      95)                  \
    TASK(medium, missionRun,             10,     3,    2670)                  \
    TASK(medium, missionCatchUp,         10,     5,    1590)                  \
    TASK(medium, runInverted,            10,     2,      15)                  \
    TASK(medium, runStall,                5,     3,      80)                  \
    TASK(medium, runFence,               20,     1,    1030)                  \
    TASK(medium, runFailsafe,            10,     6,     500)                  \
    /* an APM 1's barometer has the bus of both early in the frame */         \
    TASK(medium, runCompass,              2,     1,     250)                  \
                                                                              \
    TASK(slow,   runLog,                  2,     0,    1010)                  \
    TASK(slow,   runModeSwitch,          10,     0,     215)                  \
    TASK(slow,   runAuxSwitches,         10,     1,     150)                  \
    TASK(slow,   runEvents,              10,     5,      35)                  \
    TASK(slow,   reportVariables,        10,     7,     340)                  \
    TASK(slow,   runCamera,              10,     9,     240)                  \
    TASK(slow,   runFlaps,               10,     8,      40)                  \
    TASK(slow,   runArming,              10,     9,     425)                  \
    TASK(slow,   runBattery,             40,     9,     340)                  \
    TASK(slow,   runRollGains,           20,     0,     170)                  \
    TASK(slow,   runPitchGains,          20,     9,     180)                  \
    TASK(slow,   runControlLimits,       20,     2,      75)                  \
    TASK(slow,   runInertialSettings,    20,     1,     115)                  \
    TASK(slow,   runLateralGains,       100,    35,     280)                  \
    TASK(slow,   runTargetBearing,       20,     5,     160)                  \
    TASK(slow,   runNavBearing,          40,     0,      45)                  \
    TASK(slow,   runCompassLearning,     10,     8,     290)                  \
    TASK(slow,   tuneStep,               10,     7,     270)                  \
    TASK(slow,   parametersRun,          10,     9,    1030)                  \
    TASK(slow,   rallyFollow,           100,     3,       3)                  \
    TASK(slow,   runLights,              10,     9,      55)                  \
    TASK(slow,   dataflashStep,          10,     9,      25)                  \
    TASK(slow,   measureLoad,           100,    59,      75)                  \
    TASK(slow,   runDeclination,        100,    41,     275)                  \
    TASK(slow,   runRestartSlowly,      100,    63,     400)
// clang-format on
#define ROW(tier, run, every, in, budget_us) {tier, run, every, in, budget_us},
extern constexpr scheduler::Task kTasks[] ROM = {TASKS(ROW)};
#define NAME(tier, run, every, in, budget_us) #run,
constexpr char kTaskNames[][24] = {TASKS(NAME)};
constexpr core::PackedList<core::listCodes(kTaskNames, notify::kTextPairs)> kPackedNames
    ROM(kTaskNames, notify::kTextPairs);

namespace {

static_assert(scheduler::phasesFit(kTasks), "a phase must be smaller than its period");
static_assert(scheduler::tiersInOrder(kTasks), "fast rows stand first, slow ones last");
static_assert(scheduler::everyTaskFits(kTasks, kFrame_us), "a task can never run");
static_assert(scheduler::worstFrame_us(kTasks) <= kFrame_us * 8UL / 10,
              "a frame is more than 80 % full though everything in it takes its longest");

// By the budgets nothing ever waits. When a frame is lost, because something took far longer, all
// is caught up with after so many.
constexpr uint8_t kMediumCatchesUp = 1, kSlowCatchesUp = 2;  // frames
constexpr scheduler::LongestWait kWait = scheduler::waitAfterLostFrame(kTasks, kFrame_us);
static_assert(kWait.medium <= kMediumCatchesUp, "a medium row waits longer for one lost frame");
static_assert(kWait.slow <= kSlowCatchesUp, "a slow row waits longer for one lost frame");

// A tier that is only put off does not starve the watchdog.
static_assert(scheduler::longestSilence(kTasks, fast) <= maxSilent(fast), "fast rows do not run");
static_assert(scheduler::longestSilence(kTasks, medium) <= maxSilent(medium), "nor medium ones");
static_assert(scheduler::longestSilence(kTasks, slow) <= maxSilent(slow), "nor slow ones");

core::FileState<scheduler::Scheduler<core::count(kTasks), kTasks, kFrame_us>> schedule{};

struct Loop {
    Supervisor supervisor;
    uint16_t frame_began;  // ticks
    uint32_t load_from_us, load_busy_us;
};
core::FileState<Loop> running{};

void measureLoad() {
    const uint32_t now_us = hal::now_us();
    const uint32_t span_us = now_us - running.load_from_us;
    const uint32_t busy_us = schedule.busy_us() - running.load_busy_us;
    running.load_from_us = now_us;
    running.load_busy_us = schedule.busy_us();
    if (span_us > 1000)
        processor_figures.load_permille = static_cast<uint16_t>(busy_us / (span_us / 1000));
}

bool frameDue() {
    if (inertialSamplesWaiting() >= kSamplesPerFrame) return true;
    const uint16_t passed = hal::ticks() - running.frame_began;
    return passed >= hal::kTicksPerUs * (vehicle.imu.healthy ? kSilentImu_us : kFrame_us);
}

// The clock is looked at when the rest has ended, not at every interrupt.
bool workWaits() {
    return inertialSamplesWaiting() >= kSamplesPerFrame || telemetryWaits() || gpsWaits();
}

}  // namespace

// Inlined into main(), the variables of all that it calls would lie below every task on the stack:
// 77 bytes.
SELDOM void setup() {
    restartBegin();
    board::start();
    findBoard();
    dataflashStart();
    logStart();
    // at reset the queue is empty, so nothing is busy but what a cut left to be redone
    while (parametersLoad() == core::Status::busy) {
    }
    startOutputs();
    startSensors();
    fenceStart();
    telemetryStart();
    missionBoot();
    startModes();
    restartResume();
    if (!flyingOn()) requestMode(static_cast<Mode>(parameters.initial_mode), ModeReason::boot);
    schedule.start();
    running.frame_began = hal::ticks();
    hal::hangTimerStart();
    hal::watchdogStart();
}

void loop() {
    if (frameDue()) {
        running.frame_began = hal::ticks();
        hal::beginFrame();
        schedule.runFrame(hal::now_us());
        processor_figures.late_frames = schedule.lateFrames();
        processor_figures.longest_frame_us = schedule.longestFrame_us();
        if (running.supervisor.wellAfter(schedule.takeServed())) hal::watchdogFeed();
    } else if (gpsWaits()) {
        runGps();
    } else if (!telemetryPump() && !logFind() && !frameDue()) {  // a message takes a millisecond
        hal::idle(workWaits);
    }
}

uint8_t taskCount() { return core::count(kTasks); }
uint16_t taskLongest_us(uint8_t task) { return schedule.longest_us(task); }

gcs::TaskFigures taskFigures(uint8_t task) {
    return {notify::StatusText(core::textOfList(kPackedNames.codes, task)), taskLongest_us(task),
            core::romRead(kTasks[task].budget_us)};
}

}  // namespace app
}  // namespace firmware
