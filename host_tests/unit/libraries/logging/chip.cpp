// SPDX-License-Identifier: GPL-3.0-or-later
#include "chip.hpp"

#include "drivers/at45db.hpp"
#include "hal/clock.hpp"
#include "hal/page_flash.hpp"

namespace {

std::unique_ptr<simulator::At45db> device;
uint64_t page_reads;
bool mission_wants;

// 2 us a byte, as on the board
struct Bus {
    static uint8_t pass(uint8_t out) {
        fakes::advance_us(2);
        return device->transfer(out, fakes::time_us());
    }
    static void send(const uint8_t* bytes, uint8_t size) {
        while (size-- > 0) pass(*bytes++);
    }
    static void receive(uint8_t* to, uint8_t size) {
        while (size-- > 0) *to++ = pass(0);
    }
};
struct Select {
    static void output() {}
    static void low() { device->select(true, fakes::time_us()); }
    static void high() { device->select(false, fakes::time_us()); }
};
struct Reset {
    static void output() {}
    static void low() { device->resetPin(true, fakes::time_us()); }
    static void high() { device->resetPin(false, fakes::time_us()); }
};

drivers::At45db<Bus, Select, Reset> driver;

uint16_t now() { return static_cast<uint16_t>(hal::now_ms()); }

}  // namespace

namespace chip {

void fit(const simulator::At45dbOptions& options) {
    device = std::make_unique<simulator::At45db>(1, options);
    page_reads = 0;
    restart();
}

void restart() {
    mission_wants = false;
    driver.start(now());
    for (int i = 0; i < 200 && !driver.known(); ++i) {
        fakes::advance_ms(1);
        driver.step(now());
    }
}

void cutPower() {
    device->cutPower(fakes::time_us());
    restart();
}

simulator::At45db& model() { return *device; }
uint64_t reads() { return page_reads; }
void wantByMission(bool wants) { mission_wants = wants; }

}  // namespace chip

namespace hal {

using core::Status;

bool flashKnown() { return driver.known(); }
FlashShape flashShape() { return {driver.pages(), driver.pageSize()}; }
FlashTrouble flashTrouble() { return static_cast<FlashTrouble>(driver.trouble()); }
Status flashRead(uint16_t page, uint16_t offset, void* to, uint8_t size) {
    ++page_reads;
    return driver.read(page, offset, to, size, now());
}
Status flashFill(FlashUser user, uint16_t offset, const void* from, uint8_t size) {
    return driver.fill(static_cast<uint8_t>(user), offset, from, size, now());
}
Status flashStore(FlashUser user, uint16_t page) {
    if ((page < kFlashMissionPages) != (user == FlashUser::mission)) return Status::bad_argument;
    if (mission_wants) return Status::busy;
    return driver.store(static_cast<uint8_t>(user), page, now());
}
Status flashErase(FlashUser user, uint16_t page) {
    if ((page < kFlashMissionPages) != (user == FlashUser::mission)) return Status::bad_argument;
    if (mission_wants) return Status::busy;
    return driver.eraseBlock(page, now());
}
bool flashBusy() { return !driver.known() || driver.busy(now()); }
void flashWant(FlashUser, bool wanted) { mission_wants = wanted; }

}  // namespace hal
