// SPDX-License-Identifier: GPL-3.0-or-later
// The schedule: what runs when. main.cpp starts it and turns it for ever.
#pragma once
#include <stdint.h>

namespace firmware {

void start();  // everything in a visible order; waits for nothing
void turn();   // one frame if it is due, else received bytes, else rest

uint16_t loadPermille();     // of the frames' time spent in tasks, over the last second
uint16_t lateFrames();       // frames that ran past their period since start
uint16_t longestFrame_us();  // since start
uint8_t taskCount();
uint16_t taskLongest_us(uint8_t task);

}  // namespace firmware
