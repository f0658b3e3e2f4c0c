// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/failsafe_causes.hpp"

#include "core/based.hpp"
#include "core/file_state.hpp"
#include "firmware/safety/failsafe.hpp"
#include "firmware/safety/fence.hpp"
#include "firmware/sensors/health.hpp"
#include "firmware/state/parameters.hpp"
#include "hal/clock.hpp"
#include "hal/serial.hpp"

namespace firmware {
namespace safety {

using namespace state;
using namespace sensors;

namespace {

constexpr uint8_t kRestarted = 3;      // 0.1 s: within this the inertial sensor starts anew
constexpr uint8_t kBatterySags = 100;  // 0.1 s
constexpr uint8_t kBlownBack = 100;    // 0.1 s: ARSPD_FBW_MAX is reached, and a gust is over

struct Lasts {  // for so long, 0.1 s
    uint8_t inertial_lost, battery_low, blown_back;
    uint16_t radio_lost;
};
core::FileState<Lasts> lasts{};

bool longerThan(uint32_t ms, float s) { return ms >= static_cast<uint32_t>(s * 1000.0f); }

void count(uint8_t& tenths, bool lost, uint8_t most) {
    tenths = lost ? tenths + (tenths < most) : 0;
}

// While USB powers the board there is no pack worth watching.
bool packIsLow() {
    const auto& battery = vehicle.battery;
    if (parameters.battery_monitor == 0 || hal::usbConnected()) return false;
    const bool empty =
        parameters.battery_low_mah > 0 && parameters.battery_capacity_mah - battery.consumed_mah <
                                              core::real(parameters.battery_low_mah);
    return empty || battery.voltage_mv < parameters.battery_low_v * 1000.0f;
}

}  // namespace

void watchCauses() {
    Lasts& last = core::based<Lasts>(lasts);
    const bool lost = vehicle.armed && !vehicle.imu.healthy;
    count(last.inertial_lost, lost, kRestarted);
    // a pack recovers when the motor stops: what was low stays low
    const bool low = vehicle.armed && (last.battery_low == kBatterySags || packIsLow());
    count(last.battery_low, low, kBatterySags);
    const bool blown_back = vehicle.estimate.flying && vehicle.progress.blown_back;
    count(last.blown_back, blown_back, kBlownBack);
    if (!vehicle.armed || !vehicle.radio.lost)
        last.radio_lost = 0;
    else if (last.radio_lost != 0xFFFF)
        ++last.radio_lost;
}

// Back, the attitude is found anew first.
bool inertialLost() {
    const bool nonsense = !vehicle.imu.healthy && isFaulty(Sensor::inertial);
    return lasts.inertial_lost >= kRestarted || nonsense ||
           (failing(Cause::inertial) && !vehicle.attitude.aligned);
}
bool fenceBroken() { return fenceReport().breach != Breach::none; }
bool batteryLow() { return lasts.battery_low >= kBatterySags; }
bool blownBack() { return lasts.blown_back >= kBlownBack; }
bool radioLost() { return vehicle.radio.lost; }
bool radioLostLong() {
    return lasts.radio_lost > 0 &&
           longerThan((lasts.radio_lost - 1) * 100UL, parameters.long_timeout_s);
}
// One that was never there is not missed.
bool groundLostLong() {
    return parameters.ground_failsafe != 0 && vehicle.ground_heard_ms != 0 &&
           longerThan(hal::now_ms() - vehicle.ground_heard_ms, parameters.long_timeout_s);
}
bool positionLost() { return vehicle.estimate.flying && !vehicle.estimate.known; }
bool gpsLost() { return vehicle.estimate.reckoned; }
bool gpsJumps() { return vehicle.estimate.fix_refused; }
bool barometerLost() { return !vehicle.baro.healthy; }
bool heightLost() { return barometerLost() && gpsLost(); }
bool airspeedLost() {
    return parameters.airspeed_enable != 0 && parameters.airspeed_use != 0 &&
           !vehicle.airspeed.healthy;
}
bool compassLost() { return parameters.compass_use != 0 && !vehicle.compass.healthy; }

}  // namespace safety
}  // namespace firmware
