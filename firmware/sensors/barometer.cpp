// SPDX-License-Identifier: GPL-3.0-or-later
// Static pressure. The zero of its height is where the airplane stood when it was switched on; the
// temperature on the ground is held, as the sun on the board would else lift the airplane.
#include "board.hpp"
#include "firmware/sensors/devices.hpp"
#include "firmware/sensors/health.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/vehicle.hpp"
#include "hal/clock.hpp"

namespace firmware {
namespace sensors {

using namespace state;

namespace {

board::Barometer barometer;

// The sensor sits on a board that warms it by about this much over the air around the airplane;
// taken for the air's, its temperature would make every height 3 % too large.
constexpr float kBoardWarmth_c = 10.0f;

constexpr uint8_t kSettleReadings = 20;
constexpr uint8_t kZeroReadings = 100;

struct Zero {
    int32_t sum_pa;
    uint8_t readings;
};
Zero zero;

void takeZero(int32_t pressure_pa) {
    if (++zero.readings <= kSettleReadings) return;
    zero.sum_pa += pressure_pa;
    if (zero.readings < kSettleReadings + kZeroReadings) return;
    vehicle.baro.ground_pressure_pa = static_cast<float>(zero.sum_pa) / kZeroReadings;
    vehicle.baro.ground_temperature_c = vehicle.baro.temperature_cc * 0.01f - kBoardWarmth_c;
}

}  // namespace

void startBarometer() { barometer.start(); }

void zeroBarometer() {
    zero = {};
    vehicle.baro.ground_pressure_pa = 0;
}

void runBarometer() {
    auto& baro = vehicle.baro;
    baro.fresh = barometer.step(hal::now_us());
    const bool zeroed = baro.ground_pressure_pa > 0;
    baro.healthy = barometer.healthy() && zeroed && !isFaulty(Sensor::barometer);
    if (!baro.fresh) return;
    baro.pressure_pa = barometer.pressure_pa();
    baro.temperature_cc = static_cast<int16_t>(barometer.temperature_cc());
    baro.fresh =
        acceptReading(Sensor::barometer, static_cast<int16_t>(barometer.pressure_pa()), true);
    if (!zeroed) {
        takeZero(baro.pressure_pa);
        baro.fresh = false;
        return;
    }
}

}  // namespace sensors
}  // namespace firmware
