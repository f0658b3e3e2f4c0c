// SPDX-License-Identifier: GPL-3.0-or-later
// The modes there are, for ground stations that do not know them by their numbers: the standard
// modes protocol of MAVLink.
#pragma once
#include <stdint.h>

namespace firmware {
namespace gcs {

struct Link;

// AVAILABLE_MODES of the mode with this index, 0: of all, one after the other. False: there is
// none.
bool askForModes(Link& link, uint16_t index);
void sendAvailableModes();  // 50 Hz: the next one on every link

constexpr uint8_t kNoCustomMode = 0xFF;
uint8_t customModeOf(uint16_t standard_mode);  // kNoCustomMode: it is none of ours

}  // namespace gcs
}  // namespace firmware
