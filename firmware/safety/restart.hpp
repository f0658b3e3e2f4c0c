// SPDX-License-Identifier: GPL-3.0-or-later
// Why this run began, and how the one before it is carried on when it ended in the air:
// docs/restart.md.
#pragma once
#include <stdint.h>

#include "firmware/state/restart_record.hpp"

namespace firmware {
namespace safety {

void restartBegin();    // first of all: was it flying, and may it fly on?
bool flyingOn();        // this run goes on with a flight
bool memorySurvived();  // what ended the last run left memory as it was
bool lostTimeKnown();   // by what ended the last run: the watchdog or a fault, and no loss of power
void restartResume();   // when the sensors have been started: knows what was known

void runRestart();  // 50 Hz: keeps the record, at 25 Hz; finds the mode to fly on in, and arms
void runRestartSlowly();  // 1 Hz

}  // namespace safety
}  // namespace firmware
