// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters in RAM: one field each, named as the ground station names it. The rows that join
// field, name, range and stored slot are in parameters.cpp.
#pragma once
#include <stdint.h>

#include "core/status.hpp"

namespace firmware {

constexpr uint16_t kNoParameter = 0xFFFF;

// The table, by index 0 .. parameterCount() - 1 in a fixed order.
uint16_t parameterCount();
// MAV_PARAM_TYPE 2 int8, 4 int16, 6 int32, 9 real32; the name is padded with zeros.
bool parameterAt(uint16_t index, char (&name)[16], float& value, uint8_t& mav_type);
bool parameterFind(const char (&name)[16], uint16_t& index);

// Sets, rounds to the field's type and stores. bad_argument: no such index, not finite or out of
// range, nothing changed. busy: the store has no room yet, nothing changed: ask again later.
MUST_USE core::Status parameterSetAt(uint16_t index, float value);

// The same by the eternal slot number, as stored missions name a parameter.
bool parameterGet(uint8_t slot, float& value);
bool parameterSlotTakes(uint8_t slot, float value);  // exists, and the value is in its range
bool parameterSet(uint8_t slot, float value);        // false: refused; stored in the background

MUST_USE core::Status parametersLoad();  // at boot, a part each call: busy until all are read
void parametersRun();                    // 10 Hz: background stores

}  // namespace firmware
