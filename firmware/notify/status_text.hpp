// SPDX-License-Identifier: GPL-3.0-or-later
// Texts for the pilot (STATUSTEXT). They wait in a short queue until every link has taken them;
// a text that finds the queue full is counted, and the count is reported when there is room again.
#pragma once
#include <stdint.h>

#include "core/rom.hpp"

namespace firmware {
namespace notify {

enum class Severity : uint8_t { emergency, alert, critical, error, warning, notice, info, debug };

// The text is at most 50 characters, made by ROM_TEXT. `number` takes the place of its '#'.
void sendStatusText(Severity severity, core::RomText text);
void sendStatusText(Severity severity, core::RomText text, int32_t number);

}  // namespace notify
}  // namespace firmware
