// SPDX-License-Identifier: GPL-3.0-or-later
// Marks for whoever measures from outside: one OUT instruction to GPIOR0, which nothing else uses.
//   0x01..0x7F  task number + 1 begins        0x80  the task has ended
//   0xA0..0xAF  an event of the mission engine, its item in GPIOR1
//   0xF0        a frame begins                 0xF1  the frame's tasks are done
#pragma once
#include <stdint.h>

namespace hal {

constexpr uint8_t kMarkTaskEnd = 0x80;
constexpr uint8_t kMarkMission = 0xA0;
constexpr uint8_t kMarkFrameBegin = 0xF0;
constexpr uint8_t kMarkFrameEnd = 0xF1;

void mark(uint8_t value);
void markItem(uint8_t value, uint8_t item);

}  // namespace hal
