// SPDX-License-Identifier: GPL-3.0-or-later
// The arbiter of the DataFlash. The chip is a small double: what it does in detail is the driver's
// business and is tried there.
#include "firmware/app/dataflash.hpp"

#include <gmock/gmock.h>

#include "fakes/fakes.hpp"
#include "firmware/gcs/telemetry.hpp"
#include "hal/page_flash.hpp"

using core::Status;
using fakes::FlashBus;
using hal::FlashTrouble;
using hal::FlashUser;
using testing::ElementsAre;

namespace {

constexpr FlashUser kMission = FlashUser::mission, kLog = FlashUser::log;

class Dataflash : public testing::Test {
protected:
    void SetUp() override {
        FlashBus::device = [this](uint8_t) { return answer(); };
        FlashBus::on_select = [this](bool low) {
            if (!low && FlashBus::sent.size() > 1) last = FlashBus::sent;
            if (low) FlashBus::sent.clear();
            if (!low && last.size() == 4 && last[0] != 0x84 && last[0] != 0x87) busy = true;
        };
    }

    uint8_t answer() const {
        const std::vector<uint8_t>& sent = FlashBus::sent;
        if (!fitted || sent.size() < 2) return 0xFF;
        if (sent[0] == 0x9F) return sent.size() == 2 ? 0x1F : 0x26;
        if (sent[0] == 0xD7) return busy ? 0x2C : 0xAC;
        return 0x77;
    }
    void start() {
        busy = false;
        firmware::app::dataflashStart();
        for (int i = 0; i < 4; ++i) step();
        last.clear();
    }
    void step() {
        fakes::advance_ms(100);
        firmware::app::dataflashStep();
    }
    Status fill(FlashUser user, uint16_t offset = 0) {
        return hal::flashFill(user, offset, bytes, sizeof bytes);
    }
    Status read(uint16_t page) { return hal::flashRead(page, 0, bytes, sizeof bytes); }

    bool fitted = true, busy = false;
    std::vector<uint8_t> last;  // the newest transaction of more than a byte
    uint8_t bytes[8] = {};
};

}  // namespace

TEST_F(Dataflash, is_known_some_steps_after_the_start) {
    firmware::app::dataflashStart();
    EXPECT_FALSE(hal::flashKnown());
    EXPECT_TRUE(hal::flashBusy());
    EXPECT_EQ(read(0), Status::busy);
    EXPECT_EQ(hal::flashStore(kMission, 0), Status::busy);
    for (int i = 0; i < 4; ++i) step();

    EXPECT_TRUE(hal::flashKnown());
    EXPECT_EQ(hal::flashTrouble(), FlashTrouble::none);
    EXPECT_EQ(hal::flashShape().pages, 4096);
    EXPECT_EQ(hal::flashShape().page_size, 528);
    EXPECT_FALSE(hal::flashBusy());
}

TEST_F(Dataflash, requests_advance_it_without_the_task) {
    firmware::app::dataflashStart();
    for (int i = 0; i < 4 && !hal::flashKnown(); ++i) fakes::advance_ms(10);

    EXPECT_TRUE(hal::flashKnown());
}

TEST_F(Dataflash, gives_each_user_its_own_buffer_and_pages) {
    start();

    EXPECT_EQ(fill(kMission), Status::ok);
    EXPECT_EQ(last[0], 0x84);
    EXPECT_EQ(fill(kLog), Status::ok);
    EXPECT_EQ(last[0], 0x87);
    EXPECT_EQ(hal::flashStore(kMission, 15), Status::ok);
    EXPECT_THAT(last, ElementsAre(0x83, 0, 15 << 2, 0));
    busy = false;
    EXPECT_EQ(hal::flashStore(kLog, 16), Status::ok);
    EXPECT_THAT(last, ElementsAre(0x86, 0, 16 << 2, 0));
    busy = false;
    EXPECT_EQ(hal::flashErase(kMission, 8), Status::ok);
    EXPECT_THAT(last, ElementsAre(0x50, 0, 8 << 2, 0));
    busy = false;
    EXPECT_EQ(hal::flashErase(kLog, 4088), Status::ok);
    EXPECT_THAT(last, ElementsAre(0x50, 4088 >> 6, (4088 << 2) & 0xFF, 0));
}

TEST_F(Dataflash, refuses_pages_of_another_user_and_pages_out_of_range) {
    start();

    EXPECT_EQ(hal::flashStore(kMission, 16), Status::bad_argument);
    EXPECT_EQ(hal::flashStore(kLog, 15), Status::bad_argument);
    EXPECT_EQ(hal::flashStore(kLog, 4096), Status::bad_argument);
    EXPECT_EQ(hal::flashErase(kMission, 16), Status::bad_argument);
    EXPECT_EQ(hal::flashErase(kLog, 8), Status::bad_argument);
    EXPECT_EQ(hal::flashErase(kLog, 20), Status::bad_argument) << "begins no block";
    EXPECT_EQ(hal::flashErase(kLog, 4096), Status::bad_argument);
    EXPECT_EQ(fill(kLog, 521), Status::bad_argument);
    EXPECT_EQ(read(4096), Status::bad_argument);
    EXPECT_FALSE(busy) << "nothing was begun";
}

TEST_F(Dataflash, answers_busy_while_a_page_is_at_work_and_goes_on_after) {
    start();
    ASSERT_EQ(hal::flashStore(kLog, 100), Status::ok);

    EXPECT_TRUE(hal::flashBusy());
    EXPECT_EQ(read(0), Status::busy);
    EXPECT_EQ(hal::flashStore(kMission, 0), Status::busy);
    EXPECT_EQ(fill(kLog), Status::busy);
    EXPECT_EQ(fill(kMission), Status::ok) << "the other buffer is free";
    busy = false;
    EXPECT_FALSE(hal::flashBusy());
    EXPECT_EQ(read(0), Status::ok);
    EXPECT_EQ(bytes[7], 0x77);
    EXPECT_EQ(fill(kLog), Status::ok);
}

TEST_F(Dataflash, serves_the_mission_first) {
    start();
    hal::flashWant(kMission, true);

    EXPECT_EQ(hal::flashStore(kLog, 100), Status::busy);
    EXPECT_EQ(hal::flashErase(kLog, 96), Status::busy);
    EXPECT_EQ(fill(kLog), Status::ok) << "its buffer is its own";
    EXPECT_EQ(hal::flashStore(kMission, 1), Status::ok);
    busy = false;
    hal::flashWant(kLog, true);
    EXPECT_EQ(hal::flashStore(kLog, 100), Status::busy) << "what the log asks for changes nothing";
    hal::flashWant(kMission, false);
    EXPECT_EQ(hal::flashStore(kLog, 100), Status::ok);
}

TEST_F(Dataflash, without_a_chip_everything_is_unsupported) {
    fitted = false;
    start();

    EXPECT_TRUE(hal::flashKnown());
    EXPECT_EQ(hal::flashTrouble(), FlashTrouble::absent);
    EXPECT_EQ(hal::flashShape().pages, 0);
    EXPECT_EQ(read(0), Status::unsupported);
    EXPECT_EQ(fill(kMission), Status::unsupported);
    EXPECT_EQ(hal::flashStore(kMission, 0), Status::unsupported);
    EXPECT_EQ(hal::flashErase(kLog, 16), Status::unsupported);
    EXPECT_FALSE(hal::flashBusy());
}

TEST_F(Dataflash, a_chip_that_stays_busy_is_detected_without_a_request) {
    start();
    ASSERT_EQ(hal::flashStore(kMission, 0), Status::ok);
    step();

    EXPECT_EQ(hal::flashTrouble(), FlashTrouble::stuck);
    busy = false;
    EXPECT_EQ(hal::flashStore(kMission, 0), Status::unsupported) << "until the next start";
    EXPECT_EQ(hal::flashShape().pages, 0);
}

TEST_F(Dataflash, a_chip_that_comes_loose_is_detected) {
    start();
    ASSERT_EQ(hal::flashStore(kMission, 0), Status::ok);
    fitted = false;

    EXPECT_EQ(read(1), Status::unsupported);
    EXPECT_EQ(hal::flashTrouble(), FlashTrouble::lost);
}
