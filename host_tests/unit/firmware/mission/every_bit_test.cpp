// SPDX-License-Identifier: GPL-3.0-or-later
// A board on which everything is stored, and every bit of its EEPROM in turn changed or held by its
// cell: what the next start finds is what was stored, or a text reports it. What becomes of each
// region is in docs/architecture.md. STORAGE_BITS=1 takes every bit; without it every seventh.
#include <cstdlib>
#include <sstream>

#include "firmware/app/dataflash.hpp"
#include "firmware/safety/saved_home.hpp"
#include "hal/page_flash.hpp"
#include "mission_flight.hpp"
#include "points_rig.hpp"
#include "simulator/devices/at45db.hpp"
#include "storage/eeprom_map.hpp"
#include "storage/index_store.hpp"
#include "storage/log_base.hpp"

namespace firmware {
using namespace mission;
namespace {

constexpr uint8_t kFence = 1, kRally = 2;

class EveryBit : public Points, public testing::WithParamInterface<bool> {
protected:
    struct Found {
        std::string all, texts;
    };

    void SetUp() override {
        if (GetParam()) {
            fakes::FlashBus::device = [this](uint8_t out) { return chip.transfer(out, now_us()); };
            fakes::FlashBus::on_select = [this](bool low) { chip.select(low, now_us()); };
        }
        app::dataflashStart();
        settle(10);
        Rig::SetUp();
        for (uint8_t row = 0; row < 200; row = static_cast<uint8_t>(row + 9)) storeOneMore(row);
        ASSERT_EQ(upload({takeoff(), waypoint(500), command(181, 0, 1), waypoint(900)}),
                  MissionResult::accepted);
        ASSERT_EQ(store(kFence, fence()), MissionResult::accepted);
        ASSERT_EQ(store(kRally, {placed(5100, 200, 100, 60)}), MissionResult::accepted);
        ASSERT_TRUE(enterAuto());
        ASSERT_TRUE(missionSetCurrent(2));
        pass(3);
        ASSERT_EQ(safety::saveHome({473977000, 85456000}, 48800), core::Status::ok);
        ASSERT_EQ(storage::writeLogBase(4720), core::Status::ok);
        settle(60);
        cells = fakes::eepromCells();
        generation = static_cast<uint8_t>(mission_store.generation());
    }
    static uint64_t now_us() { return fakes::time_us(); }
    static void settle(int tenths) {
        for (int i = 0; i < tenths; ++i) {
            fakes::advance_ms(100);
            app::dataflashStep();
            if (missionReady()) missionRun();
            parametersRun();
        }
    }
    // A value of each ninth parameter that is not its default.
    static void storeOneMore(uint8_t slot) {
        float value;
        if (parameterGet(slot, value)) (void)parameterSet(slot, value + 1);
        for (int i = 0; i < 3; ++i) parametersRun();
    }
    static Items fence() {
        Items items;
        for (const int corner : {0, 1, 2, 3})
            items.push_back(placed(5001, corner < 2 ? 2000 : -2000,
                                   corner == 1 || corner == 2 ? 2000 : -2000, 0, 4));
        return items;
    }

    static void putParameters(std::ostream& out) {
        for (int slot = 0; slot < storage::kParameterSlots; ++slot) {
            float value;
            if (parameterGet(static_cast<uint8_t>(slot), value)) out << slot << '=' << value << ' ';
        }
    }
    static void putLists(std::ostream& out) {
        for (const auto kind : {ListKind::mission, ListKind::fence, ListKind::rally}) {
            out << "list " << listId(kind) << ": ";
            for (uint8_t i = 0; i < listCount(kind); ++i) {
                uint8_t record[storage::kLargestRecord] = {};
                EXPECT_EQ(listRead(kind, i, record), core::Status::ok);
                for (uint8_t byte : record) out << +byte << ' ';
            }
        }
    }
    // A start after a loss of power. The index is read before the start mends it.
    Found start() {
        fakes::restartEeprom();
        storage::IndexStore store;
        uint8_t index = 0;
        bool damaged = false;
        EXPECT_EQ(store.open(generation, index, damaged), core::Status::ok);
        safety::SavedHome home = {};
        const bool has_home = safety::readHome(home) == core::Status::ok;
        uint16_t base = 0;
        EXPECT_EQ(storage::readLogBase(base), core::Status::ok);
        (void)statusTexts();
        EXPECT_EQ(parametersLoad(), core::Status::ok);
        missionBoot();
        settle(20);
        std::ostringstream all;
        putParameters(all);
        putLists(all);
        all << "index " << +index << ", logs at " << base << ", home " << has_home;
        if (has_home)
            all << ' ' << home.position.latitude_e7 << ' ' << home.position.longitude_e7 << ' '
                << home.altitude_cm;
        return {all.str(), statusTexts()};
    }

    simulator::At45db chip;
    std::vector<uint8_t> cells;
    uint8_t generation = 0;
};

TEST_P(EveryBit, of_the_eeprom_may_change_or_be_worn_and_nothing_is_silently_another) {
    const int step = std::getenv("STORAGE_BITS") != nullptr ? 1 : 7;
    fakes::setEepromCells(cells);
    (void)start();
    fakes::setEepromCells(cells);
    const Found whole = start();
    ASSERT_EQ(whole.texts, "");
    ASSERT_NE(whole.all.find("index 2, logs at 4720, home 1"), std::string::npos) << whole.all;
    int bits = 0, same = 0;
    for (const bool worn : {false, true})
        for (int n = worn ? 3 : 0; n < 8 * hal::kEepromSize; n += step) {
            const auto at = static_cast<uint16_t>(n / 8);
            const auto mask = static_cast<uint8_t>(1 << n % 8);
            fakes::resetEeprom();
            fakes::setEepromCells(cells);
            if (worn)
                fakes::wearEepromCell(at, mask, (cells[at] & mask) == 0);
            else
                fakes::setEepromCell(at, cells[at] ^ mask);
            const Found first = start();
            ASSERT_TRUE(first.all == whole.all || !first.texts.empty())
                << at << ", bit " << n % 8 << (worn ? ", worn\n" : "\n") << first.all;
            const Found second = start();
            ASSERT_TRUE(second.all == first.all || !second.texts.empty())
                << at << ", bit " << n % 8 << (worn ? ", worn\n" : "\n") << second.all;
            same += first.all == whole.all;
            ++bits;
        }
    printf("%d changed or held bits, none of effect with %d of them, none silent\n", bits, same);
    EXPECT_GT(same, bits / 2);
}

std::string nameOf(const testing::TestParamInfo<bool>& board) {
    return board.param ? "with_a_dataflash" : "without_one";
}
INSTANTIATE_TEST_SUITE_P(Board, EveryBit, testing::Bool(), nameOf);

}  // namespace
}  // namespace firmware
