// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/app/dataflash.hpp"

#include "board.hpp"
#include "core/file_state.hpp"
#include "drivers/at45db.hpp"
#include "firmware/notify/status_text.hpp"
#include "hal/clock.hpp"
#include "hal/page_flash.hpp"

namespace firmware {
namespace app {

using namespace notify;

namespace {

using core::Status;
using hal::FlashUser;

constexpr uint8_t kPagesPerBlock = 8;
static_assert(hal::kFlashMissionPages % kPagesPerBlock == 0, "a block has one owner");

struct FlashUse {
    drivers::At45db<board::FlashBus, board::FlashSelect, board::FlashReset> chip;
    bool mission_wants;
    bool trouble_reported;
};
core::FileState<FlashUse> flash{};

uint16_t clock_ms() { return static_cast<uint16_t>(hal::now_ms()); }

bool owns(FlashUser user, uint16_t page) {
    return (page < hal::kFlashMissionPages) == (user == FlashUser::mission);
}

// May this user begin work on this page?
Status admit(FlashUser user, uint16_t page) {
    if (!owns(user, page)) return Status::bad_argument;
    return flash.mission_wants && user != FlashUser::mission ? Status::busy : Status::ok;
}

void reportTrouble() {
    switch (flash.chip.trouble()) {
        case drivers::At45dbTrouble::none:
            return;
        case drivers::At45dbTrouble::absent:
            sendStatusText(Severity::warning, STATUS_TEXT("DataFlash: none found"));
            break;
        case drivers::At45dbTrouble::stuck:
            sendStatusText(Severity::error,
                           STATUS_TEXT("DataFlash: stays busy, not used any more"));
            break;
        case drivers::At45dbTrouble::garbled:
            sendStatusText(Severity::error, STATUS_TEXT("DataFlash: lost, not used any more"));
            break;
    }
    flash.trouble_reported = true;
}

}  // namespace

void dataflashStart() {
    flash.mission_wants = flash.trouble_reported = false;
    flash.chip.start(clock_ms());
}

void dataflashStep() {
    flash.chip.step(clock_ms());
    if (!flash.trouble_reported) reportTrouble();
}

}  // namespace app
}  // namespace firmware

namespace hal {

using namespace firmware::app;

bool flashKnown() {
    if (!flash.chip.known()) flash.chip.step(clock_ms());
    return flash.chip.known();
}

FlashShape flashShape() { return {flash.chip.pages(), flash.chip.pageSize()}; }
FlashTrouble flashTrouble() { return static_cast<FlashTrouble>(flash.chip.trouble()); }

Status flashRead(uint16_t page, uint16_t offset, void* to, uint8_t size) {
    return flash.chip.read(page, offset, to, size, clock_ms());
}

Status flashFill(FlashUser user, uint16_t offset, const void* from, uint8_t size) {
    return flash.chip.fill(static_cast<uint8_t>(user), offset, from, size, clock_ms());
}

Status flashStore(FlashUser user, uint16_t page) {
    const Status status = admit(user, page);
    return status == Status::ok ? flash.chip.store(static_cast<uint8_t>(user), page, clock_ms())
                                : status;
}

Status flashErase(FlashUser user, uint16_t page) {
    if (page % kPagesPerBlock != 0) return Status::bad_argument;
    const Status status = admit(user, page);
    return status == Status::ok ? flash.chip.eraseBlock(page, clock_ms()) : status;
}

bool flashBusy() { return !flash.chip.known() || flash.chip.busy(clock_ms()); }

void flashWant(FlashUser user, bool wanted) {
    if (user == FlashUser::mission) flash.mission_wants = wanted;
}

}  // namespace hal
