// SPDX-License-Identifier: GPL-3.0-or-later
#include "fakes/page_flash.hpp"

#include <string.h>

#include <algorithm>

#include "fakes/clock.hpp"
#include "hal/page_flash.hpp"

namespace {

constexpr uint64_t kPage_us = 20000;  // AT45DB161D datasheet, tEP: 17 ms, at most 40 ms
constexpr uint16_t kPages = 4096, kPageSize = 528;

struct Chip {
    bool fitted = false, known = true, slow = false, occupied = false, wanted = false;
    fakes::FlashPages pages;
    std::vector<uint8_t> buffers[2];
    // what is being programmed
    int page = -1, buffer = 0;
    uint64_t until_us = 0;
    uint32_t writes = 0;
    uint32_t noise = 1;

    void damage(std::vector<uint8_t>& cells) {
        for (uint8_t& cell : cells)
            cell = static_cast<uint8_t>((noise = noise * 1664525u + 1013904223u) >> 24);
    }
    void damageInFlight(std::vector<uint8_t>& cells, const std::vector<uint8_t>& written) {
        const bool half = fakes::tearsWrites();
        if (!half || fakes::tornNoise() % 2 == 0) damage(cells);
        const auto whole = static_cast<long>(half ? fakes::tornNoise() % cells.size() : 0);
        std::copy(written.begin(), written.begin() + whole, cells.begin());
    }
    void catchUp() {
        if (page < 0 || fakes::time_us() < until_us) return;
        if (fakes::powerCut_us() >= until_us) pages[static_cast<size_t>(page)] = buffers[buffer];
        page = -1;
    }
    bool busy() {
        catchUp();
        return page >= 0 || occupied;
    }
};

Chip chip;

core::Status usable(uint16_t page, uint16_t offset, uint8_t size) {
    if (!chip.known) return core::Status::busy;
    if (!chip.fitted) return core::Status::unsupported;
    return page < kPages && offset + size <= kPageSize ? core::Status::ok
                                                       : core::Status::bad_argument;
}

}  // namespace

namespace fakes {

void resetPageFlash() { chip = Chip(); }

void fitPageFlash() {
    chip = Chip();
    chip.fitted = true;
    const std::vector<uint8_t> blank(kPageSize, 0xFF);
    chip.pages.assign(hal::kFlashMissionPages, blank);
    chip.buffers[0] = chip.buffers[1] = blank;
}

void removePageFlash() { chip.fitted = false; }
void setPageFlashKnown(bool known) { chip.known = known; }
void setPageFlashSlow(bool slow) { chip.slow = slow; }
void holdPageFlashBusy(bool busy) { chip.occupied = busy; }
bool missionWantsPageFlash() { return chip.wanted; }
uint32_t pageWrites() { return chip.writes; }

FlashPages flashPages() {
    chip.catchUp();
    return chip.pages;
}
void setFlashPages(const FlashPages& pages) {
    chip.pages = pages;
    restartPageFlash();
}
void damagePage(uint16_t page) { chip.damage(chip.pages.at(page)); }

void restartPageFlash() {
    chip.catchUp();
    if (chip.page >= 0 && powerWasCut())
        chip.damageInFlight(chip.pages[static_cast<size_t>(chip.page)], chip.buffers[chip.buffer]);
    chip.page = -1;
    chip.occupied = chip.wanted = false;
    for (std::vector<uint8_t>& buffer : chip.buffers) chip.damage(buffer);
}

}  // namespace fakes

namespace hal {

using core::Status;

bool flashKnown() { return chip.known; }
FlashShape flashShape() {
    return {static_cast<uint16_t>(chip.fitted && chip.known ? kPages : 0), kPageSize};
}

Status flashRead(uint16_t page, uint16_t offset, void* to, uint8_t size) {
    const Status status = usable(page, offset, size);
    if (status != Status::ok) return status;
    if (chip.busy()) return Status::busy;
    memcpy(to, &chip.pages.at(page)[offset], size);
    return Status::ok;
}

Status flashFill(FlashUser user, uint16_t offset, const void* from, uint8_t size) {
    const Status status = usable(0, offset, size);
    if (status != Status::ok) return status;
    const int buffer = static_cast<int>(user);
    chip.catchUp();
    if (chip.page >= 0 && chip.buffer == buffer) return Status::busy;
    memcpy(&chip.buffers[buffer][offset], from, size);
    return Status::ok;
}

Status flashStore(FlashUser user, uint16_t page) {
    const Status status = usable(page, 0, 0);
    if (status != Status::ok) return status;
    if ((page < kFlashMissionPages) != (user == FlashUser::mission)) return Status::bad_argument;
    if (chip.busy()) return Status::busy;
    const fakes::Fate fate = fakes::beginWrite();
    if (fate == fakes::Fate::lost) return Status::ok;  // the program does not know yet
    ++chip.writes;
    chip.page = page;
    chip.buffer = static_cast<int>(user);
    chip.until_us = fakes::time_us() + (chip.slow ? kPage_us : 0);
    if (fate == fakes::Fate::damaged) {
        chip.damageInFlight(chip.pages.at(page), chip.buffers[chip.buffer]);
        chip.page = -1;
    }
    return Status::ok;
}

Status flashErase(FlashUser, uint16_t) { return Status::unsupported; }
bool flashBusy() { return !chip.known || chip.busy(); }

void flashWant(FlashUser user, bool wanted) {
    if (user == FlashUser::mission) chip.wanted = wanted;
}

}  // namespace hal
