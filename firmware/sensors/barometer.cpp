// SPDX-License-Identifier: GPL-3.0-or-later
// Static pressure and the height that follows from it. The zero is where the airplane stood when
// it was switched on; the temperature on the ground is held, as the sun on the board would else
// lift the airplane.
#include "board.hpp"
#include "core/maths.hpp"
#include "drivers/ms5611.hpp"
#include "firmware/sensors/devices.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/vehicle.hpp"
#include "hal/clock.hpp"

namespace firmware {
namespace {

drivers::Ms5611<board::SensorBus, board::BarometerSelect> barometer;

constexpr uint8_t kSettleReadings = 20;
constexpr uint8_t kZeroReadings = 100;
constexpr float kScaleHeight_mPerK = 29.271267f;  // R / (g M): hypsometric equation

struct Zero {
    float sum_pa;
    uint8_t readings;
};
Zero zero;
float ground_temperature_k = 288.15f;

void takeZero(float pressure_pa) {
    if (++zero.readings <= kSettleReadings) return;
    zero.sum_pa += pressure_pa;
    if (zero.readings < kSettleReadings + kZeroReadings) return;
    vehicle.baro.ground_pressure_pa = zero.sum_pa / kZeroReadings;
    ground_temperature_k = vehicle.baro.temperature_c + 273.15f;
}

}  // namespace

void startBarometer() { barometer.start(); }

void zeroBarometer() {
    zero = {};
    vehicle.baro.ground_pressure_pa = 0;
}

// ln(x) by its series about 1, exact to 2 mm of height within 300 m of the zero and monotonic
// beyond; the libm logarithm costs ten times as much.
static float logarithm(float ratio) {
    const float y = (ratio - 1.0f) / (ratio + 1.0f);
    const float y2 = y * y;
    return 2.0f * y * (1.0f + y2 * (1.0f / 3.0f + y2 * (1.0f / 5.0f)));
}

void runBarometer() {
    auto& baro = vehicle.baro;
    baro.fresh = barometer.step(hal::now_us());
    const bool zeroed = baro.ground_pressure_pa > 0;
    baro.healthy = barometer.healthy() && zeroed;
    if (!baro.fresh) return;
    baro.pressure_pa = barometer.pressure_pa();
    baro.temperature_c = barometer.temperature_cc() * 0.01f;
    if (!zeroed) {
        takeZero(baro.pressure_pa);
        baro.fresh = false;
        return;
    }
    baro.height_m = logarithm(baro.ground_pressure_pa / baro.pressure_pa) * ground_temperature_k *
                    kScaleHeight_mPerK;
}

}  // namespace firmware
