// SPDX-License-Identifier: GPL-3.0-or-later
// A DataFlash that comes loose while what was committed there is not yet in the EEPROM: what
// cannot be read any more is never waited for.
#include "firmware/app/dataflash.hpp"
#include "hal/page_flash.hpp"
#include "host_tests/support/spelt.hpp"
#include "mission_flight.hpp"
#include "simulator/devices/at45db.hpp"

namespace firmware {
using namespace mission;
using namespace app;
namespace {

class LostFlash : public MissionFlight {
protected:
    void SetUp() override {
        fakes::FlashBus::device = [this](uint8_t out) { return chip.transfer(out, now_us()); };
        fakes::FlashBus::on_select = [this](bool low) { chip.select(low, now_us()); };
        dataflashStart();
        for (int i = 0; i < 10; ++i) step();
        MissionFlight::SetUp();
    }
    static uint64_t now_us() { return fakes::time_us(); }
    static void step() {
        fakes::advance_ms(100);
        dataflashStep();
    }
    // The flight begins at once, the copying home does not.
    static void flyUncopied(const Items& items) {
        ASSERT_EQ(upload(items), MissionResult::accepted);
        ASSERT_TRUE(requestMode(Mode::automatic, ModeReason::ground));
        while (missionCurrent() == 0 || mission_engine.midPass()) mission_engine.poll(false);
        mutable_vehicle.demand.new_path = false;
        mutable_vehicle.progress = {};
        (void)statusTexts();
    }
    // Noticed when it is asked for its work next, as the log does all the time.
    void lose() {
        while (hal::flashStore(hal::FlashUser::log, 100) == core::Status::busy) {
            fakes::advance_ms(5);
        }
        chip.remove();
        fakes::advance_ms(1);
        (void)hal::flashBusy();
        ASSERT_EQ(hal::flashTrouble(), hal::FlashTrouble::lost);
    }
    static void reachUncopied() {
        mutable_vehicle.progress.distance_m = 0;
        do mission_engine.poll(false);
        while (mission_engine.midPass());
    }

    simulator::At45db chip;
};

TEST_F(LostFlash, ends_the_mission_in_rtl_and_is_reported) {
    flyUncopied({waypoint(500), command(181, 0, 1), waypoint(900), waypoint(1500)});
    EXPECT_EQ(missionCurrent(), 1);
    lose();
    mutable_vehicle.progress.distance_m = 5000;
    pass(2);
    EXPECT_EQ(vehicle.mode, Mode::automatic) << "what is flown needs no record";
    (void)statusTexts();
    reach();
    seconds(1);
    EXPECT_TRUE(hasStatusText("cannot be read"));
    EXPECT_EQ(vehicle.mode, Mode::rtl);
}

TEST_F(LostFlash, makes_of_a_mission_that_cannot_be_compared_another_one) {
    const Items items = {waypoint(500), waypoint(900), waypoint(1500)};
    flyUncopied(items);
    reachUncopied();
    EXPECT_EQ(missionCurrent(), 2);
    ASSERT_EQ(missionBeginUpload(4), MissionResult::accepted);
    ASSERT_EQ(missionUploadItem(0, placed(16, 0, 0, 0)), MissionResult::accepted);
    for (size_t i = 0; i < 3; ++i)
        ASSERT_EQ(missionUploadItem(static_cast<uint16_t>(i + 1), items[i]),
                  MissionResult::accepted);
    while (!missionChanging()) {
        EXPECT_EQ(missionCommit(), MissionResult::busy);
        step();
    }
    lose();
    EXPECT_EQ(whileBusy(missionCommit), MissionResult::accepted);
    EXPECT_NE(missionCurrent(), 2) << "not flown on as if it were the same";
}

// Climbing straight on must end somewhere.
TEST_F(LostFlash, leaves_a_landing_that_was_broken_off_to_be_flown_again) {
    flyUncopied({waypoint(500), placed(21, 900, 0, 0), waypoint(1500)});
    reachUncopied();
    ASSERT_EQ(missionCurrent(), 2);
    mutable_vehicle.estimate.flying = true;
    ASSERT_EQ(vehicle.demand.path, Path::land);
    ASSERT_EQ(vehicle.mode, Mode::automatic);
    ASSERT_TRUE(missionGoAround(60));
    mutable_vehicle.demand.new_path = false;
    lose();
    mutable_vehicle.estimate.height_m = 60;
    seconds(3);
    EXPECT_EQ(missionCurrent(), 1) << "which is in memory: it is not climbing on beside item 2";
}

TEST_F(LostFlash, does_not_make_auto_wait_for_a_mission_it_lost_while_that_was_looked_for) {
    ASSERT_EQ(upload({waypoint(500), waypoint(900)}), MissionResult::accepted);
    lose();
    missionBoot();
    for (int i = 0; i < 50; ++i) missionRun();
    firmware::notify::StatusText why_not;
    EXPECT_FALSE(missionEnter(why_not));
    EXPECT_EQ(spelt(why_not), "AUTO: mission cannot be read");
}

}  // namespace
}  // namespace firmware
