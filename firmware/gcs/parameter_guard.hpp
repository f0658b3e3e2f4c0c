// SPDX-License-Identifier: GPL-3.0-or-later
// What a ground station may set beyond what the parameters themselves take: docs/security.md.
#pragma once
#include "firmware/gcs/link.hpp"

namespace firmware {
namespace gcs {

// False: it may not be set now, the reason reported.
bool parameterMayBeSet(const Link& link, uint16_t index);

// A write of another value is counted, and after too many `parameterMayBeSet` refuses: an EEPROM
// cell is good for 100,000 (data sheet, features), which a loop of PARAM_SET would reach in hours.
bool parameterChanges(uint16_t index, float value);
void parameterWritten();

void parameterGuardTick();  // kTickRate_hz

}  // namespace gcs
}  // namespace firmware
