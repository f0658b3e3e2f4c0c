// SPDX-License-Identifier: GPL-3.0-or-later
// Calibrations that take their time, and the conversation with the ground station about them.
#pragma once
#include <stdint.h>

namespace firmware {
namespace gcs {

struct Link;

enum class Calibrating : uint8_t {
    nothing,
    rest,     // gyros, pressures: it stands still
    level,    // the accelerometers' offsets, standing level
    sides,    // their offsets and scales, on six sides one after the other
    compass,  // turned about
};
Calibrating calibrating();

struct Asker {
    uint8_t link, system, component;  // who is told how it goes
};
// False: another one runs.
bool calibrationBegin(Calibrating what, const Asker& asker);
// Of the sides and the compass; nothing of it is kept.
void calibrationCancel();
// The airplane lies as it was asked for: a key was pressed on the ground. False: nobody asked.
bool calibrationSideIsReady();
bool calibrationSideIsReady(uint16_t accelcal_vehicle_pos);
void calibrationTurn();  // kTurns_hz
void calibrationReset();

// From this slot on. False: a value is none for its parameter, nothing was stored.
bool storeAll(uint8_t slot, const float* values, uint8_t count);

}  // namespace gcs
}  // namespace firmware
