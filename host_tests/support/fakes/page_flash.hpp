// SPDX-License-Identifier: GPL-3.0-or-later
// The tests' DataFlash behind libraries/hal/page_flash.hpp: absent until it is fitted, quick by
// default, on request as slow as the real one. A page whose programming the power did not last
// for is noise. Programs that have the driver and its bus in them do not use this one.
#pragma once
#include <stdint.h>

#include <vector>

#include "fakes/power.hpp"

namespace fakes {

void resetPageFlash();  // none is there
void fitPageFlash();    // one with blank pages
void removePageFlash();
void setPageFlashKnown(bool known);  // false: it has not answered yet

// A page takes 20 ms of the fake clock.
void setPageFlashSlow(bool slow);
void holdPageFlashBusy(bool busy);  // as if the log had it
bool missionWantsPageFlash();

using FlashPages = std::vector<std::vector<uint8_t>>;  // the mission's
FlashPages flashPages();
void setFlashPages(const FlashPages& pages);
void damagePage(uint16_t page);
uint32_t pageWrites();

void restartPageFlash();  // as after a reset or a power cut

}  // namespace fakes
