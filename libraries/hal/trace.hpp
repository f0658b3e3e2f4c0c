// SPDX-License-Identifier: GPL-3.0-or-later
// A trace of what the program does, read from outside: one OUT instruction to GPIOR0, which nothing
// else uses.
//   0x01..0x7F  task number + 1 begins        0x80  the task has ended
//   0xA0..0xAF  an event of the mission engine, its item in GPIOR1
//   0xF0        a frame begins                 0xF1  the frame's tasks are done
#pragma once
#include <stdint.h>

namespace hal {

constexpr uint8_t kTraceTaskEnd = 0x80;
constexpr uint8_t kTraceMission = 0xA0;
constexpr uint8_t kTraceFrameBegin = 0xF0;
constexpr uint8_t kTraceFrameEnd = 0xF1;

void trace(uint8_t value);
void traceItem(uint8_t value, uint8_t item);

}  // namespace hal
