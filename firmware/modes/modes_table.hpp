// SPDX-License-Identifier: GPL-3.0-or-later
// What every mode's file provides, one pair a mode. start: enters or refuses, the reason reported.
// run: 100 Hz, after the sticks are read and before the attitude is controlled. demand: 20 Hz,
// before guidance flies it.
#pragma once
#include <stdint.h>

namespace firmware {
namespace modes {

enum class Entry : uint8_t { entered, refused, home_instead };

Entry startManual();
void runManual();

Entry startStabilize();
void runStabilize();

Entry startTraining();
void runTraining();

Entry startAcro();
void runAcro();

Entry startFbwa();
void runFbwa();

Entry startAutotune();

Entry startFbwb();
void runFbwb();
void demandFbwb();

Entry startCruise();
void runCruise();
void demandCruise();

Entry startCircle();
void runCircle();

Entry startAuto();
void runAuto();
void stopAuto();

Entry startRtl();
void runRtl();

Entry startLoiter();
void runLoiter();

Entry startTakeoff();
void runTakeoff();
void demandTakeoff();

Entry startGuided();
void runGuided();

}  // namespace modes
}  // namespace firmware
