// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/calibration.hpp"

#include "core/file_state.hpp"
#include "core/rom.hpp"
#include "firmware/gcs/command_handlers.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/sensors/accelerometer_fit.hpp"
#include "firmware/sensors/compass_learning.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameter_slots.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/published.hpp"
#include "hal/clock.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<CalibrationState> : Writable<CalibrationState> {
    using Writable::state;
};
}  // namespace state

namespace gcs {

using namespace notify;
using namespace state;
using namespace sensors;

namespace {

constexpr CalibrationState& published = Publisher<CalibrationState>::state();

using mavlink::AccelcalVehiclePos;
using mavlink::MavCmd;
using mavlink::MavResult;

constexpr uint8_t kRest_s = 30, kSide_s = 240, kTurning_s = 180;

core::FileState<SideForces> sides{};

enum class Phase : uint8_t { asks, measures, succeeded, failed };

struct Calibration {
    Phase phase;
    uint8_t side;
    uint8_t left_s;
    uint8_t second;  // of the clock
    Asker asker;
};
core::FileState<Calibration> now{};

// The words by which ground stations know them.
constexpr TextField<25> kPrompts[kSides] ROM = {
    "Place vehicle level and press any key.",
    "Place vehicle on its LEFT side and press any key.",
    "Place vehicle on its RIGHT side and press any key",
    "Place vehicle nose DOWN and press any key.",
    "Place vehicle nose UP and press any key.",
    "Place vehicle on its BACK and press any key.",
};

Link& link() { return links[now.asker.link]; }

bool secondHasPassed() {
    const uint8_t second = static_cast<uint8_t>(hal::now_ms() / 1024);
    if (second == now.second) return false;
    now.second = second;
    if (now.left_s > 0) --now.left_s;
    return true;
}

CommandRequest requestFor(uint16_t command) {
    CommandRequest request;
    request.command = command;
    request.system = now.asker.system;
    request.component = now.asker.component;
    return request;
}

bool acknowledge(uint8_t result) {
    return gcs::acknowledge(link(), requestFor(MavCmd::preflight_calibration), result);
}

bool reportSide(uint32_t position) {
    mavlink::CommandLong message = {};
    message.command = MavCmd::accelcal_vehicle_pos;
    message.param1 = static_cast<float>(position);
    message.target_system = now.asker.system;
    message.target_component = now.asker.component;
    return send(link(), message);
}

void askForSide() {
    now.phase = Phase::asks;
    now.left_s = kSide_s;
    sendStatusText(Severity::notice, kPrompts[now.side]);
    reportSide(now.side + 1U);
}

void end(bool well, StatusText why) {
    now.phase = well ? Phase::succeeded : Phase::failed;
    sendStatusText(well ? Severity::notice : Severity::error, why);
}
void endWell() { end(true, STATUS_TEXT("Calibration successful")); }

// ---- level
uint8_t takeLevel() {
    core::Vector3 offset_mss = restForce_mss();
    offset_mss.z += core::kGravity_mss;
    const float values[] = {offset_mss.x, offset_mss.y, offset_mss.z, 1, 1, 1};
    return whenTrue(
        liesOn(kLevelSide, restForce_mss()) && parametersSetFrom(slot::ins_accoffs_x, values, 6),
        MavResult::failed);
}

// ---- sides
void takeTrim(const AccelerometerFit& fit) {
    core::Vector3 force_mss = sides.at(kLevelSide);
    float* const axes = &force_mss.x;
    for (uint8_t i = 0; i < 3; ++i) axes[i] = (axes[i] - fit.offset_mss[i]) * fit.scale[i];
    float lie_rad[2];
    lieOf(force_mss, lie_rad);
    if (!parametersSetFrom(slot::ahrs_trim_x, lie_rad, 2))
        sendStatusText(Severity::warning, STATUS_TEXT("Level was not: AHRS_TRIM stays"));
}

void finishSides() {
    AccelerometerFit fit;
    if (!fitSides(sides, fit) || !parametersSetFrom(slot::ins_accoffs_x, fit.offset_mss, 6))
        return end(false, STATUS_TEXT("Calibration FAILED: out of range"));
    takeTrim(fit);
    endWell();
}

void takeSide() {
    if (!liesOn(now.side, restForce_mss())) {
        sendStatusText(Severity::warning, STATUS_TEXT("That is another side: not taken"));
        return askForSide();
    }
    sides.put(now.side, restForce_mss());
    if (++now.side == kSides) return finishSides();
    askForSide();
}

void sidesTick() {
    const bool passed = secondHasPassed();
    switch (now.phase) {
        case Phase::asks:
            if (passed) reportSide(now.side + 1U);
            if (now.left_s == 0) end(false, STATUS_TEXT("Calibration FAILED: nobody answers"));
            return;
        case Phase::measures:
            if (vehicle.imu.calibrated) return takeSide();
            if (now.left_s == 0) end(false, STATUS_TEXT("Calibration FAILED: keep it still"));
            return;
        default: {
            const uint32_t outcome = now.phase == Phase::succeeded ? AccelcalVehiclePos::success
                                                                   : AccelcalVehiclePos::failed;
            if (reportSide(outcome)) published.calibrating = Calibrating::nothing;
        }
    }
}

// ---- compass
void reportProgress() {
    mavlink::MagCalProgress message = {};
    message.cal_mask = 1;
    message.cal_status = mavlink::MagCalStatus::running_step_one;
    message.completion_pct = compassTurns_pct();
    send(link(), message);
}

bool report() {
    const bool well = now.phase == Phase::succeeded;
    mavlink::MagCalReport message = {};
    message.cal_mask = 1;
    message.cal_status = well ? mavlink::MagCalStatus::success : mavlink::MagCalStatus::failed;
    message.autosaved = well;
    message.fitness = compassMiss_mg();
    message.ofs_x = parameters.compass.offset_mg[0];
    message.ofs_y = parameters.compass.offset_mg[1];
    message.ofs_z = parameters.compass.offset_mg[2];
    message.diag_x = message.diag_y = message.diag_z = 1;
    return send(link(), message);
}

void finishCompass() {
    const uint8_t within_mg = now.left_s > 0 ? 12 : 30;
    if (compassFits(within_mg) &&
        parametersSetFrom(slot::compass_ofs_x, parameters.compass.offset_mg, 3)) {
        endWell();
    } else if (now.left_s == 0) {
        end(false, STATUS_TEXT("Calibration FAILED: magnet or iron near?"));
    }
}

void compassTick() {
    if (now.phase != Phase::asks) {
        if (!report()) return;
        if (now.phase == Phase::failed) restoreStoredOffsets();
        published.calibrating = Calibrating::nothing;
        return;
    }
    if (!secondHasPassed()) return;
    if (compassTurns_pct() == 100) {
        finishCompass();
    } else if (now.left_s == 0) {
        end(false, STATUS_TEXT("Calibration FAILED: turn it all about"));
    }
    reportProgress();
}

// ---- rest, level
void restTick() {
    const bool still = vehicle.imu.calibrated && core::isPositive(vehicle.baro.ground_pressure_pa);
    if (!secondHasPassed() && !still && now.left_s > 0) return;
    uint8_t result = now.left_s > 0 ? MavResult::in_progress : MavResult::failed;
    if (still) result = MavResult::accepted;
    if (still && vehicle.calibrating == Calibrating::level) result = takeLevel();
    if (acknowledge(result) && result != MavResult::in_progress)
        published.calibrating = Calibrating::nothing;
}

}  // namespace

bool calibrationBegin(Calibrating what, const Asker& asker) {
    if (vehicle.calibrating != Calibrating::nothing && vehicle.calibrating != what) return false;
    const bool again = vehicle.calibrating == what;
    now.asker = asker;
    if (again && what == Calibrating::rest) return true;
    published.calibrating = what;
    now.phase = Phase::asks;
    now.side = 0;
    now.left_s = what == Calibrating::compass ? kTurning_s : kRest_s;
    if (what == Calibrating::level) calibrateGyros();
    if (what == Calibrating::compass && !again) compassTurnsStart();
    if (what == Calibrating::sides) askForSide();
    return true;
}

void calibrationCancel() {
    if (vehicle.calibrating == Calibrating::compass) restoreStoredOffsets();
    published.calibrating = Calibrating::nothing;
}

bool calibrationSideIsReady() { return calibrationSideIsReady(now.side + 1U); }

bool calibrationSideIsReady(uint16_t accelcal_vehicle_pos) {
    if (vehicle.calibrating != Calibrating::sides || now.phase != Phase::asks ||
        accelcal_vehicle_pos != now.side + 1U)
        return false;
    now.phase = Phase::measures;
    now.left_s = kRest_s;
    calibrateGyros();
    return true;
}

void calibrationTick() {
    static constexpr void (*kTicks[])() ROM = {nullptr, restTick, restTick, sidesTick, compassTick};
    if (vehicle.calibrating == Calibrating::nothing) return;
    if (vehicle.armed) return calibrationCancel();
    core::romRead(kTicks[static_cast<uint8_t>(vehicle.calibrating)])();
}

void calibrationReset() {
    now = {};
    published.calibrating = Calibrating::nothing;
}

}  // namespace gcs
}  // namespace firmware
