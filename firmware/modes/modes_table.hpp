// SPDX-License-Identifier: GPL-3.0-or-later
// What every mode's file provides, one pair a mode. start: enters or refuses, the reason reported.
// run: 100 Hz, after the sticks are read and before the attitude is controlled. demand: 20 Hz,
// before guidance flies it.
#pragma once
#include <stdint.h>

namespace firmware {
namespace modes {

enum class EntryResult : uint8_t { entered, refused, home_instead };

EntryResult startManual();
void runManual();

EntryResult startStabilize();
void runStabilize();

EntryResult startTraining();
void runTraining();

EntryResult startAcro();
void runAcro();

EntryResult startFbwa();
void runFbwa();

EntryResult startAutotune();

EntryResult startFbwb();
void runFbwb();
void demandFbwb();

EntryResult startCruise();
void runCruise();
void demandCruise();

EntryResult startCircle();
void runCircle();

EntryResult startAuto();
void runAuto();
void stopAuto();

EntryResult startRtl();
void runRtl();

EntryResult startLoiter();
void runLoiter();

EntryResult startTakeoff();
void runTakeoff();
void demandTakeoff();

EntryResult startGuided();
void runGuided();

}  // namespace modes
}  // namespace firmware
