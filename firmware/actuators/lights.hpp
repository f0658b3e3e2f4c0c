// SPDX-License-Identifier: GPL-3.0-or-later
// The three lights of the board: A armed, C GPS, B radio.
#pragma once

namespace firmware {
namespace actuators {

void runLights();  // 10 Hz

}  // namespace actuators
}  // namespace firmware
