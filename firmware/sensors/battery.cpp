// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/battery.hpp"

#include "core/file_state.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/published.hpp"
#include "hal/analog.hpp"
#include "hal/clock.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<BatteryState> : Writable<BatteryState> {
    using Writable::state;
};
}  // namespace state

namespace sensors {

using namespace state;

namespace {

constexpr BatteryState& published = Publisher<BatteryState>::state();

struct PowerModule {
    drivers::Battery pack;
    uint32_t updated_ms;
};
core::FileState<PowerModule> power_module{};

constexpr int8_t kVoltageAndCurrent = 4;  // BATT_MONITOR

bool mean(hal::Analog input, float& reading) {
    const hal::AnalogSum sum = hal::analogTake(input);
    if (sum.count == 0) return false;
    reading = static_cast<float>(sum.sum) / core::real(sum.count);
    return true;
}

}  // namespace

void runBattery() {
    float volts = 0;
    float amps = 0;
    float band_gap = 0;
    const bool has_volts = mean(hal::Analog::battery_voltage, volts);
    const bool has_amps = mean(hal::Analog::battery_current, amps);
    const bool has_board = mean(hal::Analog::board_voltage, band_gap);
    if (!has_volts || !has_amps || !has_board) return;
    published.board_mv = drivers::boardSupply_mv(static_cast<uint16_t>(band_gap + 0.5f));
    const uint32_t now_ms = hal::now_ms();
    const float dt_s = (now_ms - power_module.updated_ms) * 0.001f;
    power_module.updated_ms = now_ms;
    if (parameters.battery_monitor == 0) {
        published.voltage_mv = 0;
        published.current_ca = -1;
        return;
    }
    drivers::BatterySettings settings;
    settings.volts_per_volt = parameters.battery_volt_multiplier;
    settings.amps_per_volt = parameters.battery_amps_per_volt;
    settings.amps_offset_v = parameters.battery_amps_offset_v;
    power_module.pack.update(volts, amps, published.board_mv, dt_s, settings);
    published.voltage_mv = static_cast<uint16_t>(power_module.pack.voltage_v() * 1000.0f);
    published.current_ca = parameters.battery_monitor == kVoltageAndCurrent
                               ? static_cast<int16_t>(power_module.pack.current_a() * 100.0f)
                               : -1;
    published.consumed_mah = power_module.pack.consumed_mah();
}

}  // namespace sensors
}  // namespace firmware
