// SPDX-License-Identifier: GPL-3.0-or-later
// Battery voltage and current from a power module's two analogue outputs.
#pragma once
#include <stdint.h>

namespace drivers {

struct BatterySettings {
    float volts_per_volt = 10.1f;  // BATT_VOLT_MULT: the module's divider
    float amps_per_volt = 17.0f;   // BATT_AMP_PERVOLT; 0: no current sensor
    float amps_offset_v = 0;       // BATT_AMP_OFFSET
};

class Battery {
public:
    // Means of 10-bit readings against the board's supply. Gaps longer than 2 s are not integrated.
    void update(float voltage_reading, float current_reading, uint16_t board_mv, float dt_s,
                const BatterySettings& settings);

    float voltage_v() const { return voltage_v_; }
    float current_a() const { return current_a_; }
    float consumed_mah() const { return consumed_mah_; }

private:
    float voltage_v_ = 0, current_a_ = 0, consumed_mah_ = 0;
    bool started_ = false;
};

// The supply from a reading of the 1.1 V band gap against it; 0 keeps 5 V. Held in 4..6 V.
uint16_t boardSupply_mv(uint16_t band_gap_reading);

}  // namespace drivers
