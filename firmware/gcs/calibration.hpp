// SPDX-License-Identifier: GPL-3.0-or-later
// Calibrations that take their time, and the conversation with the ground station about them.
#pragma once
#include <stdint.h>

#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace gcs {

struct Link;

struct Asker {
    uint8_t link, system, component;  // who gets the progress
};
// False: another one runs.
bool calibrationBegin(state::Calibrating what, const Asker& asker);
// Of the sides and the compass; nothing of it is stored.
void calibrationCancel();
// The airplane lies as it was asked for: a key was pressed on the ground. False: nobody asked.
bool calibrationSideIsReady();
bool calibrationSideIsReady(uint16_t accelcal_vehicle_pos);
void calibrationTick();  // 50 Hz
void calibrationReset();

}  // namespace gcs
}  // namespace firmware
