// SPDX-License-Identifier: GPL-3.0-or-later
// The schedule: what runs when. main.cpp calls setup() once and loop() for ever.
#pragma once
#include <stdint.h>

#include "firmware/gcs/host.hpp"

namespace firmware {
namespace app {

void setup();  // everything in a visible order; waits for nothing
void loop();   // one frame if it is due, else received bytes, else rest

uint8_t taskCount();
uint16_t taskLongest_us(uint8_t task);
gcs::TaskFigures taskFigures(uint8_t task);

}  // namespace app
}  // namespace firmware
