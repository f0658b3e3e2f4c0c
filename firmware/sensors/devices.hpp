// SPDX-License-Identifier: GPL-3.0-or-later
// Between the files of this folder only.
#pragma once

namespace firmware {
namespace sensors {

void startInertial();
void startBarometer();
void startCompass();
void startGps();
void zeroBarometer();
void zeroAirspeed();

}  // namespace sensors
}  // namespace firmware
