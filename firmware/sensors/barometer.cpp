// SPDX-License-Identifier: GPL-3.0-or-later
// Static pressure. The zero of its height is where the airplane stood when it was switched on; the
// temperature on the ground is held, as the sun on the board would else lift the airplane.
#include "board.hpp"
#include "core/convert.hpp"
#include "core/file_state.hpp"
#include "core/seldom.hpp"
#include "firmware/sensors/devices.hpp"
#include "firmware/sensors/health.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/published.hpp"
#include "hal/clock.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<BarometerState> : Writable<BarometerState> {
    using Writable::state;
};
}  // namespace state

namespace sensors {

using namespace state;

namespace {

constexpr BarometerState& published = Publisher<BarometerState>::state();

core::FileState<board::Barometer> barometer{};

// The sensor sits on a board that warms it by about this much over the air around the airplane;
// taken for the air's, its temperature would make every height 3 % too large.
constexpr float kBoardWarmth_c = 10.0f;

constexpr uint8_t kSettleReadings = 20;
constexpr uint8_t kZeroReadings = 100;
constexpr int32_t kFar_pa = 60;  // 5 m, from the reading before

struct Zero {
    int32_t sum_pa;
    uint8_t readings;
};
core::FileState<Zero> zero{};

// A zero with readings in it that a noisy bus has garbled would be wrong for the whole flight.
SELDOM void takeZero(int32_t before_pa) {
    const int32_t pressure_pa = published.pressure_pa, change_pa = pressure_pa - before_pa;
    if (change_pa > kFar_pa || change_pa < -kFar_pa) zero = {};
    if (++zero.readings <= kSettleReadings) return;
    zero.sum_pa += pressure_pa;
    if (zero.readings < kSettleReadings + kZeroReadings) return;
    published.ground_pressure_pa = static_cast<float>(zero.sum_pa) / kZeroReadings;
    published.ground_temperature_c = core::hundredths(published.temperature_cc) - kBoardWarmth_c;
}

}  // namespace

void startBarometer() { barometer.start(); }

void zeroBarometer() {
    zero = {};
    published.ground_pressure_pa = 0;
}

void resumeBarometer(float ground_pressure_pa, float ground_temperature_c) {
    published.ground_pressure_pa = ground_pressure_pa;
    published.ground_temperature_c = ground_temperature_c;
}

void runBarometer() {
    const bool arrived = barometer.step(hal::now_us());
    const bool zeroed = core::isPositive(published.ground_pressure_pa);
    published.healthy = barometer.healthy() && zeroed && !isFaulty(Sensor::barometer);
    if (!arrived) return;
    const int32_t before_pa = published.pressure_pa;
    published.pressure_pa = barometer.pressure_pa();
    published.temperature_cc = static_cast<int16_t>(barometer.temperature_cc());
    const bool accepted =
        acceptReading(Sensor::barometer, static_cast<int16_t>(barometer.pressure_pa()), true);
    if (!zeroed) return takeZero(before_pa);
    if (accepted) ++published.readings;
}

}  // namespace sensors
}  // namespace firmware
