// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters in an EEPROM whose bits change by themselves, whose cells are worn, and whose power is
// cut: every value is what was stored, or it is said that they are damaged.
// STORAGE_BITS=1 changes every bit; without it every seventh.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "fakes/fakes.hpp"
#include "storage/eeprom_map.hpp"
#include "storage/journal.hpp"

namespace {

using core::Status;
using storage::Journal;
using Found = Journal::Found;
using Values = std::map<uint16_t, uint32_t>;

bool all() { return std::getenv("STORAGE_BITS") != nullptr; }
uint32_t noise(uint32_t n) { return (n + 1) * 2654435761u ^ n << 7; }

class DamagedParameters : public testing::Test {
protected:
    void SetUp() override {
        fakes::reset();
        Journal journal;
        ASSERT_EQ(journal.recover(), Status::ok);
        for (uint16_t slot = 0; slot < storage::kParameterSlots; slot += 3) {
            values[slot] = noise(slot);
            ASSERT_EQ(journal.write(slot, values[slot]), Status::ok);
        }
        for (uint16_t slot = 9; slot < 40; slot += 9) {  // some again
            values[slot] = noise(slot + 1000);
            ASSERT_EQ(journal.write(slot, values[slot]), Status::ok);
        }
        cells = fakes::eepromCells();
    }

    static uint32_t wantedOf(const Values& wanted, uint16_t slot) {
        const auto value = wanted.find(slot);
        return value == wanted.end() ? 0xFFFFFFFF : value->second;
    }
    // Slots whose value is another one.
    static int wrong(const Journal& journal, const Values& wanted) {
        int count = 0;
        for (uint16_t slot = 0; slot < storage::kParameterSlots; ++slot) {
            uint32_t value = 0;
            EXPECT_EQ(journal.read(slot, value), Status::ok);
            count += value != wantedOf(wanted, slot);
        }
        return count;
    }
    static void flip(uint16_t at, int bit) {
        fakes::setEepromCell(at, static_cast<uint8_t>(fakes::eepromCell(at) ^ 1 << bit));
    }
    static bool inParameters(uint16_t at) {
        return at < storage::kParameters.end() ||
               (at >= storage::kJournal.begin && at < storage::kJournal.end()) ||
               (at >= storage::kChecks.begin && at < storage::kChecks.end());
    }
    // Of all bits, with what a test makes of each.
    template <class Call>
    static void eachBit(int step, Call call) {
        for (uint16_t at = storage::kParameters.begin; at < storage::kChecks.end(); ++at)
            for (int bit = 0; bit < 8; ++bit)
                if (inParameters(at) && (all() || (at * 8 + bit) % step == 0)) call(at, bit);
    }

    Values values;
    std::vector<uint8_t> cells;
};

TEST_F(DamagedParameters, whole_ones_are_sound_and_nothing_is_written) {
    const uint32_t before = fakes::eepromWrites();
    Journal journal;
    ASSERT_EQ(journal.recover(), Status::ok);
    EXPECT_EQ(journal.found(), Found::sound);
    EXPECT_EQ(wrong(journal, values), 0);
    EXPECT_EQ(fakes::eepromWrites(), before);
}

TEST_F(DamagedParameters, any_changed_bit_is_mended_for_good) {
    int flips = 0, mended = 0;
    eachBit(7, [&](uint16_t at, int bit) {
        fakes::setEepromCells(cells);
        flip(at, bit);
        Journal journal;
        ASSERT_EQ(journal.recover(), Status::ok);
        ASSERT_NE(journal.found(), Found::damaged) << at << ", " << bit;
        ASSERT_EQ(wrong(journal, values), 0) << at << ", " << bit;
        mended += journal.found() == Found::mended;
        fakes::restartEeprom();
        Journal next;
        ASSERT_EQ(next.recover(), Status::ok);
        ASSERT_EQ(next.found(), Found::sound) << at << ", " << bit;
        ASSERT_EQ(wrong(next, values), 0);
        ++flips;
    });
    printf("%d changed bits, %d of them reported, none silent\n", flips, mended);
    EXPECT_GT(mended, 0.85 * flips) << "all but those of the journal and of its newest slot";
}

TEST_F(DamagedParameters, two_changed_bits_are_reported_at_every_start_until_accepted) {
    for (uint32_t n = 0; n < (all() ? 20'000 : 500); ++n) {
        const auto at = [](uint32_t random) {
            return static_cast<uint16_t>(storage::kParameters.begin +
                                         random % storage::kParameters.size);
        };
        const uint32_t first = noise(2 * n), second = noise(2 * n + 1);
        if (at(first) / 4 == 27 / 4 || at(second) / 4 == 27 / 4) continue;
        fakes::setEepromCells(cells);
        flip(at(first), first >> 28 & 7);
        flip(at(second), second >> 28 & 7);
        if (fakes::eepromCells() == cells) continue;
        for (int start = 0; start < 2; ++start) {
            Journal journal;
            ASSERT_EQ(journal.recover(), Status::ok);
            if (journal.found() == Found::damaged) continue;
            ASSERT_EQ(wrong(journal, values), 0) << n << ": the newest entry's slot was one";
        }
    }
    fakes::setEepromCells(cells);
    flip(storage::parameterAddress(100), 1);
    flip(storage::parameterAddress(101), 2);
    Journal journal;
    ASSERT_EQ(journal.recover(), Status::ok);
    ASSERT_EQ(journal.found(), Found::damaged);
    ASSERT_EQ(journal.write(50, 123), Status::ok);
    Journal after;
    ASSERT_EQ(after.recover(), Status::ok);
    EXPECT_EQ(after.found(), Found::damaged) << "a stored value does not hide it";
    while (after.trust() == Status::busy) {
    }
    EXPECT_EQ(after.found(), Found::sound);
    Journal last;
    ASSERT_EQ(last.recover(), Status::ok);
    EXPECT_EQ(last.found(), Found::sound);
}

// The supply was too low to write with.
TEST_F(DamagedParameters, a_value_that_was_not_kept_is_written_again) {
    constexpr uint16_t kSlot = 60;
    fakes::setEepromSlow(true);
    Journal journal;
    while (journal.recover() == Status::busy) fakes::advance_ms(1);
    ASSERT_EQ(journal.write(kSlot, 0), Status::ok);
    fakes::advance_ms(200);
    fakes::setEepromCell(storage::parameterAddress(kSlot), 0x63);
    for (int i = 0; i < 10 && !journal.applyPending(); ++i) fakes::advance_ms(200);
    EXPECT_EQ(fakes::eepromCell(storage::parameterAddress(kSlot)), 0);
    EXPECT_FALSE(journal.takeWorn());
    fakes::restartEeprom();
    fakes::setEepromSlow(false);
    Journal next;
    ASSERT_EQ(next.recover(), Status::ok);
    EXPECT_EQ(next.found(), Found::sound);
}

// A cell that wears out in use, through several values, with others stored between.
TEST_F(DamagedParameters, a_worn_cell_costs_no_value_and_is_reported) {
    int worn = 0, reported = 0;
    eachBit(7, [&](uint16_t at, int bit) {
        for (const bool high : {false, true}) {
            fakes::resetEeprom();
            fakes::setEepromCells(cells);
            Values wanted = values;
            Journal journal;
            ASSERT_EQ(journal.recover(), Status::ok);
            fakes::wearEepromCell(at, static_cast<uint8_t>(1 << bit), high);
            bool noticed = false;
            const auto slot = static_cast<uint16_t>(
                at < storage::kParameters.end() ? (at - storage::kParameters.begin) / 4 : 77);
            if (fakes::eepromCell(at) != cells[at]) {  // as if it had worn out before
                journal = Journal();
                ASSERT_EQ(journal.recover(), Status::ok);
                noticed = journal.found() != Found::sound;
            }
            for (uint32_t n = 0; n < 6; ++n) {
                const uint16_t to = n % 2 == 0 ? slot : static_cast<uint16_t>(slot ^ 4);
                wanted[to] = noise(at * 8u + static_cast<uint32_t>(bit) + 100 * n);
                ASSERT_EQ(journal.write(to, wanted[to]), Status::ok);
                while (!journal.applyPending()) {
                }
                noticed = journal.takeWorn() || noticed;
                ASSERT_EQ(wrong(journal, wanted), 0) << at << ", " << bit << ", " << high;
            }
            fakes::restartEeprom();
            Journal next;
            ASSERT_EQ(next.recover(), Status::ok);
            ASSERT_NE(next.found(), Found::damaged) << at << ", " << bit << ", " << high;
            ASSERT_EQ(wrong(next, wanted), 0) << at << ", " << bit << ", " << high;
            ++worn;
            reported += noticed || next.found() != Found::sound;
        }
    });
    printf("%d worn cells, %d of them reported, no value lost\n", worn, reported);
}

// Values that follow as soon as there is room: each is read back before the next, or the check
// would go on from what is not there, and undo a good value at the next start.
TEST_F(DamagedParameters, a_worn_cell_under_values_that_follow_at_once_costs_none) {
    constexpr uint16_t kWorn = 61, kOther = 62;  // blank: a bit that is stuck is not seen
    constexpr uint8_t kBit = 0x10;
    fakes::wearEepromCell(storage::parameterAddress(kWorn), kBit, true);
    fakes::setEepromSlow(true);
    Journal journal;
    const auto soon = [](auto call) {
        while (call() == Status::busy) fakes::advance_ms(1);
    };
    soon([&] { return journal.recover(); });
    for (const uint32_t value : {0u, uint32_t{kBit}}) {
        soon([&] { return journal.write(kWorn, value); });
        soon([&] { return journal.write(kOther, value + 1); });
        while (!journal.applyPending()) fakes::advance_ms(1);
        fakes::advance_ms(1000);
    }
    values[kWorn] = kBit;
    values[kOther] = kBit + 1;
    fakes::restartEeprom();
    fakes::setEepromSlow(false);
    Journal next;
    ASSERT_EQ(next.recover(), Status::ok);
    EXPECT_NE(next.found(), Found::damaged);
    EXPECT_EQ(wrong(next, values), 0);
}

// As the power can be cut with every write of a value and again in what mends it.
TEST_F(DamagedParameters, cuts_of_a_write_and_of_the_recovery_leave_the_old_or_the_new_value) {
    int cuts = 0;
    for (uint32_t n = 0; n < (all() ? 200 : 10); ++n) {
        const auto slot = static_cast<uint16_t>(n * 37 % storage::kParameterSlots);
        for (uint32_t first = 0; first < 20; ++first)
            for (uint32_t second = 0; second < 20; second += all() ? 1 : 3) {
                fakes::setEepromCells(cells);
                Values wanted = values;
                Journal writer;
                ASSERT_EQ(writer.recover(), Status::ok);
                fakes::cutPowerAfter(first);
                ASSERT_EQ(writer.write(slot, noise(n + 7000)), Status::ok);
                fakes::restartEeprom();
                Journal again;
                fakes::cutPowerAfter(second);
                ASSERT_EQ(again.recover(), Status::ok);
                fakes::restartEeprom();
                Journal reader;
                ASSERT_EQ(reader.recover(), Status::ok);
                ASSERT_NE(reader.found(), Found::damaged) << first << ", " << second;
                uint32_t value = 0;
                ASSERT_EQ(reader.read(slot, value), Status::ok);
                if (value != wantedOf(values, slot)) wanted[slot] = noise(n + 7000);
                ASSERT_EQ(wrong(reader, wanted), 0) << first << ", " << second;
                ++cuts;
            }
    }
    printf("%d pairs of power cuts\n", cuts);
}

TEST_F(DamagedParameters, of_a_version_without_checks_stay_and_get_them) {
    for (uint16_t at = storage::kChecks.begin; at < storage::kChecks.end(); ++at)
        fakes::setEepromCell(at, 0xFF);
    Journal journal;
    ASSERT_EQ(journal.recover(), Status::ok);
    EXPECT_EQ(journal.found(), Found::sound);
    EXPECT_EQ(wrong(journal, values), 0);
    EXPECT_EQ(fakes::eepromCells(), cells);
}

}  // namespace
