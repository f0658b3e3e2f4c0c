// SPDX-License-Identifier: GPL-3.0-or-later
// The board's DataFlash (AT45DB161D or AT45DB321D) as its users share it. The chip has two page
// buffers of its own and takes milliseconds to erase or program a page, so nothing here waits: who
// gets `busy` and asks again in a later frame. Each user has one of the two buffers, and pages that
// are its alone; where both want the chip at once, the mission is served first.
#pragma once
#include <stdint.h>

#include "core/status.hpp"

namespace hal {

enum class FlashUser : uint8_t { mission, log };

// The mission's pages are the first ones; the log has all the others.
constexpr uint16_t kFlashMissionPages = 16;

struct FlashShape {
    uint16_t pages;      // 4096 or 8192; 0: no chip that works
    uint16_t page_size;  // 528, or 512 where the chip was set to powers of two
};

// Why there is no chip that works: nobody answered at start; it stayed busy longer than it may; it
// no longer says what it is.
enum class FlashTrouble : uint8_t { none, absent, stuck, lost };

// Known once the chip has been asked, in the first frames after start: asking takes it further.
// Until then every flash function answers busy; once there is trouble, unsupported. Trouble may
// also come later and stays until the next start.
bool flashKnown();
FlashShape flashShape();
FlashTrouble flashTrouble();

// Reads from a page, past the buffers. busy: a page is being erased or programmed (at most 40 ms,
// a block 100 ms; datasheet "tEP", "tBE"). bad_argument: past the end of the chip or of the page.
// unsupported: no chip.
MUST_USE core::Status flashRead(uint16_t page, uint16_t offset, void* to, uint8_t size);

// Writes into the user's buffer. busy: that buffer is being programmed.
MUST_USE core::Status flashFill(FlashUser user, uint16_t offset, const void* from, uint8_t size);

// Erases `page` and programs the user's buffer into it; ok: begun. The page holds the data once
// flashBusy() is false, and flashRead() answers no sooner. A power cut in between leaves the page
// in any state, the others untouched. bad_argument: not a page of this user's.
MUST_USE core::Status flashStore(FlashUser user, uint16_t page);

// Erases the block of eight pages which `page` begins; ok: begun. bad_argument: it begins none, or
// not a page of this user's.
MUST_USE core::Status flashErase(FlashUser user, uint16_t page);

// Also while the chip is not yet known.
bool flashBusy();

// The user wants the chip next: the log's flashStore and flashErase get busy while the
// mission wants it.
void flashWant(FlashUser user, bool wanted);

}  // namespace hal
