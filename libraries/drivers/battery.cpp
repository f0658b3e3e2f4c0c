// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/battery.hpp"

#include "core/maths.hpp"

namespace drivers {

void Battery::update(float voltage_reading, float current_reading, uint16_t board_mv, float dt_s,
                     const BatterySettings& settings) {
    const float volts_per_count = board_mv * (0.001f / 1024.0f);
    const float volts = voltage_reading * volts_per_count * settings.volts_per_volt;
    const float amps =
        settings.amps_per_volt * (current_reading * volts_per_count - settings.amps_offset_v);
    const float share = started_ ? 0.2f : 1.0f;
    voltage_v_ = core::lerp(voltage_v_, volts, share);
    current_a_ = core::lerp(current_a_, amps, share);
    started_ = true;
    if (dt_s < 2.0f) consumed_mah_ += amps * dt_s * (1000.0f / 3600.0f);
}

uint16_t boardSupply_mv(uint16_t band_gap_reading) {
    if (band_gap_reading == 0) return 5000;
    const uint32_t supply_mv = 1126400UL / band_gap_reading;  // 1.1 V * 1024
    return static_cast<uint16_t>(core::limit<uint32_t>(supply_mv, 4000, 6000));
}

}  // namespace drivers
