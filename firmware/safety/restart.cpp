// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/restart.hpp"

#include <math.h>

#include "core/based.hpp"
#include "core/file_state.hpp"
#include "core/internal_error.hpp"
#include "core/maths.hpp"
#include "core/rom.hpp"
#include "core/seldom.hpp"
#include "firmware/estimator/estimator.hpp"
#include "firmware/mission/home.hpp"
#include "firmware/modes/modes.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/safety/arming.hpp"
#include "firmware/safety/restart_evidence.hpp"
#include "firmware/safety/restart_records.hpp"
#include "firmware/safety/saved_home.hpp"
#include "firmware/sensors/radio.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/published.hpp"
#include "hal/clock.hpp"
#include "hal/trace.hpp"
#include "hal/watchdog.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<RestartState> : Writable<RestartState> {
    using Writable::state;
};
}  // namespace state

namespace safety {

using namespace notify;
using namespace state;
using namespace sensors;
using namespace estimator;
using namespace mission;
using namespace modes;

namespace {

constexpr RestartState& published = Publisher<RestartState>::state();

using hal::ResetCause;

// In the order of ResetCause; the number is that of the task, from 1 on.
constexpr TextField<18> kCauses[] ROM = {
    "Started by the supply",       "Started by the reset button",
    "Restarted after a brown-out", "Restarted by watchdog, task #",
    "Started by a reset",          "Restarted by a fault, task #",
    "Restarted as asked",
};

struct Restart {
    bool reported;
    bool arms;             // as soon as there is evidence that the airplane is in the air
    bool records_written;  // since the motor was armed, or by the run that this one goes on with
    bool home_saved;       // in the EEPROM, by this run or the one it goes on with
    bool saves_next;       // 25 Hz: the rate is known, for which the attitude is turned on
    uint8_t errors_reported;
    uint8_t switch_position, switch_looks;  // the same position so often
};
core::FileState<Restart> restart{};

constexpr uint8_t kFewPeriods = 10;  // of blind samples that give a rate
constexpr uint8_t kLooks = 3;        // at the mode switch, 20 ms apart
constexpr uint16_t kSwitchComesWithin_ms = 200, kSensorsComeWithin_ms = 450;

void fill(FastRecord& to, bool in_the_air) {
    saveEstimate(to);
    to.at_ms = static_cast<uint16_t>(hal::now_ms());
    to.mode = static_cast<uint8_t>(vehicle.mode);
    to.in_the_air = in_the_air;
    to.home_set = vehicle.home.set;
}

// Without an attitude the last pose stays, and is said to be old; its clock alone would go round.
// Height and place are still measured.
void keepPose(FastRecord& to, const FastRecord& from) {
    constexpr uint16_t kOld_ms = 1000;
    to.pose = from.pose;
    to.rate_rads = from.rate_rads;
    to.mode = from.mode;
    to.at_ms -= kOld_ms;
    if (static_cast<int16_t>(to.at_ms - from.at_ms) < 0) to.at_ms = from.at_ms;
}

void saveFastRecord() {
    const bool aligned = vehicle.attitude.aligned;
    if (!aligned && !restart.records_written) return;
    const FlightSigns signs = {vehicle.armed, vehicle.estimate.flying,
                               vehicle.estimate.ground_speed_mps, aboveField_m()};
    FastRecord& to = nextFastRecord();
    fill(to, inTheAir(signs));
    if (!aligned) keepPose(to, newestFastRecord());
    finishFastRecord();
    restart.records_written = true;
}

// Disarmed there is no flight to go on with, whatever the last record says.
void forgetFlight() {
    if (!restart.records_written) return;
    restart.records_written = false;
    for (FastRecord& each : records.fast) invalidate(each);
}

void saveSlowRecord() {
    SlowRecord& slow = core::based(records.slow);
    slow.home = vehicle.home.position;
    slow.home_altitude_cm = vehicle.home.altitude_cm;
    slow.ground_pressure_pa = vehicle.baro.ground_pressure_pa;
    slow.ground_temperature_c = vehicle.baro.ground_temperature_c;
    slow.airspeed_offset_v = airspeedOffset_v();
    saveGyroZero(slow.gyro_zero_rad);
    saveEstimate(slow);
    updateChecksum(slow);
}

// Where the pilot's switch stands; without a receiver what was flown before.
bool modeToFlyOnIn(Mode& mode) {
    const uint8_t position = modeSwitchPosition();
    restart.switch_looks = position == restart.switch_position ? restart.switch_looks + 1 : 0;
    restart.switch_position = position;
    if (position != 0 && restart.switch_looks >= kLooks - 1) {
        mode = static_cast<Mode>(parameters.switch_mode[position - 1]);
        return true;
    }
    mode = static_cast<Mode>(flightToResume()->mode);
    return hal::now_ms() >= kSwitchComesWithin_ms;
}

SELDOM void decideMode() {
    const bool blind = !vehicle.attitude.aligned && hal::now_ms() < kSensorsComeWithin_ms;
    Mode mode;
    const bool known = modeToFlyOnIn(mode);  // looks at the switch while blind, too
    if (blind || !known) return;
    if (!requestMode(mode, ModeReason::restart)) requestMode(Mode::fbwa, ModeReason::restart);
    if (lostTimeKnown()) {
        armAfterRestart();
    } else {
        restart.arms = true;
    }
    published.resuming = false;
}

float fieldHeight_m() { return records.slow.home_height_m - records.slow.home_above_field_m; }

// Once barometer and airspeed sensor have had their time only the receiver can say so, and another
// restart does not find a flight to go on with. Of a receiver that was refused once nothing counts.
SELDOM void armOnEvidence() {
    const bool sensors_count = !sensorsHadTheirTime();
    const bool seen = receiverSeesItMove() || (sensors_count && measuredInTheAir(fieldHeight_m()));
    if (!sensors_count && !seen) forgetFlight();
    restart.arms =
        !vehicle.armed && !seen && !receiverRefused() && (sensors_count || !receiverHadItsTime());
    if (vehicle.armed || restart.arms) return;
    if (seen) return armAfterRestart();
    sendStatusText(Severity::critical, STATUS_TEXT("Not armed again: not seen flying"));
}

// Half a second after the start: in the air the log is open by then.
SELDOM void reportCause() {
    const hal::LastRun& run = hal::lastRun();
    const Severity severity = flyingOn()         ? Severity::critical
                              : memorySurvived() ? Severity::warning
                                                 : Severity::info;
    constexpr uint8_t kBetweenTasks = 0;
    const uint8_t task = run.trace < hal::kTraceTaskEnd ? run.trace : kBetweenTasks;
    sendStatusText(severity, kCauses[static_cast<uint8_t>(run.ended)], task);
    restart.reported = true;
}

void reportInternalErrors() {
    const core::InternalErrors& errors = core::internalErrors();
    if (errors.changes == restart.errors_reported) return;
    restart.errors_reported = errors.changes;
    sendStatusText(Severity::critical, STATUS_TEXT("Internal error #"),
                   static_cast<uint8_t>(errors.last));
}

bool homeIsSaved() {
    const auto& home = core::based(vehicle.home);
    return restart.home_saved && records.slow.home.latitude_e7 == home.position.latitude_e7 &&
           records.slow.home.longitude_e7 == home.position.longitude_e7 &&
           records.slow.home_altitude_cm == home.altitude_cm;
}

// A flight that goes on after a restart is not over because it is not armed again yet.
void saveHomeOfFlight() {
    if (vehicle.resuming || restart.arms) return;
    if (vehicle.armed && vehicle.home.set && !homeIsSaved())
        restart.home_saved =
            saveHome(vehicle.home.position, vehicle.home.altitude_cm) == core::Status::ok;
    if (!vehicle.armed && restart.home_saved) restart.home_saved = forgetHome() != core::Status::ok;
}

// The power went in flight, or was taken from an armed airplane: it may be in the air.
void takeSavedHome() {
    SavedHome home;
    core::Status status;
    while ((status = readHome(home)) == core::Status::busy) {
    }
    if (status != core::Status::ok) return;
    resumeHome(home.position, home.altitude_cm);
}

float lostSoFar_s() {
    const hal::LastRun& run = hal::lastRun();
    const bool noted = lostTimeKnown();
    const uint16_t saved_ms = flightToResume()->at_ms;
    const uint16_t ended_ms = noted ? run.ended_ms : saved_ms;
    const uint16_t restart_ms =
        noted ? run.restart_ms : static_cast<uint16_t>(parameters.loader_ms);
    return lost_s(saved_ms, ended_ms, static_cast<uint16_t>(hal::now_ms()) + restart_ms);
}

// As an interrupt has watched it while the program hung; the rest as quick as before.
core::Vector3 turnedSince_rad(float since_s) {
    const auto& rate = flightToResume()->rate_rads;
    const HangDeltaAngle& turn = records.hang.turn;
    // A roll dies out within some tenths of a second, a turn goes on.
    constexpr float kRollGoesOn_s = 0.4f;
    const core::Vector3 goes_on_rad = {rate.x.toFloat() * fminf(since_s, kRollGoesOn_s),
                                       rate.y.toFloat() * since_s, rate.z.toFloat() * since_s};
    if (!isValid(records.hang, *flightToResume()) || turn.periods < kFewPeriods) return goes_on_rad;
    const float seen_s = turn.periods * estimation::kSamplePeriod_s;
    return hangTurn_rad(turn) * (since_s / seen_s);
}

}  // namespace

SELDOM void restartResume() {
    restart = {};
    published.resuming = restart.records_written = flyingOn();
    if (!flyingOn()) return takeSavedHome();
    const FastRecord& last = *flightToResume();
    const SlowRecord& slow = core::based(records.slow);
    resumeInertial(slow.gyro_zero_rad);
    const float lost_for_s = lostSoFar_s();
    resumeEstimate(slow, last, turnedSince_rad(lost_for_s), lost_for_s);
    resumeBarometer(slow.ground_pressure_pa, slow.ground_temperature_c);
    resumeAirspeed(slow.airspeed_offset_v);
    if (last.home_set) resumeHome(slow.home, slow.home_altitude_cm);
    restart.home_saved = true;
}

void runRestart() {
    if (vehicle.resuming) decideMode();
    if (vehicle.mode == Mode::initialising) return;
    if (restart.arms) armOnEvidence();
    if (restart.arms) return;
    if (!vehicle.armed) return forgetFlight();
    restart.saves_next = !restart.saves_next;
    if (!restart.saves_next) return;
    saveFastRecord();
}

void runRestartSlowly() {
    if (!restart.reported) reportCause();
    reportInternalErrors();
    saveHomeOfFlight();
    if (vehicle.attitude.aligned && vehicle.mode != Mode::initialising) saveSlowRecord();
}

}  // namespace safety
}  // namespace firmware
