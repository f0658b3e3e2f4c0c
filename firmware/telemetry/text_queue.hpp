// SPDX-License-Identifier: GPL-3.0-or-later
// The links' and the log's side of text.hpp.
#pragma once
#include <stdint.h>

namespace firmware {

struct Link;

constexpr uint8_t kTextSize = 50;  // of STATUSTEXT

bool textSend(Link& link);  // the oldest text this link has not had; false: none, or no room
bool textWaits(const Link& link);
bool textWaitsForLog();
bool textForLog(char* to);  // the oldest the log has not had, kTextSize characters
void textLogged();          // it has it now
uint8_t textsLost();        // not yet told

}  // namespace firmware
