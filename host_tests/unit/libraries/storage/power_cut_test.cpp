// SPDX-License-Identifier: GPL-3.0-or-later
// Power cuts in the middle of every single write to EEPROM and DataFlash of a change, and of the
// copying after it. Whoever boots after one finds the old or the new list, whole.
// STORAGE_CUTS=n makes so many of those that are drawn: torn, and again in the recovery.
#include <cstdlib>

#include "rig.hpp"

namespace {

struct Change {
    const char* name;
    ListKind kind;
    Mission before, after;
    uint8_t set_after;
    Status (*make)(MissionStore&, const Change&);
};

Status makeUpload(MissionStore& store, const Change& change) {
    return upload(store, change.after, change.set_after, change.kind);
}
Status makePartial(MissionStore& store, const Change& change) {
    return partial(store, 3, 9, change.after);
}

Mission withPart(Mission base, uint8_t first, uint8_t last, uint8_t seed) {
    const Mission other = mission(static_cast<uint8_t>(base.size()), seed);
    for (uint8_t i = first; i <= last; ++i) base[i] = other[i];
    return base;
}

const Mission kSixty = mission(60, 1), kNone;
const Change kAnywhere[] = {
    {"longer", ListKind::mission, mission(30, 1), mission(80, 2), 2, makeUpload},
    {"shorter", ListKind::mission, mission(80, 1), mission(12, 2), 2, makeUpload},
    {"first and full", ListKind::mission, kNone, mission(171, 2), 2, makeUpload},
    {"clear", ListKind::mission, kSixty, kNone, 2, makeUpload},
    {"part", ListKind::mission, kSixty, withPart(kSixty, 3, 9, 4), 2, makePartial},
    {"other set", ListKind::mission, kSixty, kSixty, 1, makeUpload},
    {"fence", ListKind::fence, records(ListKind::fence, 9, 5), records(ListKind::fence, 11, 6), 2,
     makeUpload},
    {"rally", ListKind::rally, records(ListKind::rally, 4, 5), records(ListKind::rally, 5, 6), 2,
     makeUpload},
};
const Change kBeside[] = {
    {"round the ring", ListKind::mission, mission(85, 1), mission(86, 2), 2, makeUpload},
};
const Change kFull[] = {
    {"full over full", ListKind::mission, mission(171, 1), mission(171, 2), 2, makeUpload},
    {"full over small", ListKind::mission, mission(3, 1), mission(171, 2), 2, makeUpload},
    {"small over full", ListKind::mission, mission(171, 1), mission(3, 2), 2, makeUpload},
    {"full fence", ListKind::fence, records(ListKind::fence, 20, 5),
     records(ListKind::fence, 20, 6), 2, makeUpload},
    {"full rally", ListKind::rally, records(ListKind::rally, 10, 5),
     records(ListKind::rally, 10, 6), 2, makeUpload},
};

struct Memories {
    std::vector<uint8_t> eeprom;
    fakes::FlashPages flash;
};
Memories remember() { return {fakes::eepromCells(), fakes::flashPages()}; }
void recall(const Memories& memories) {
    fakes::setFlashPages(memories.flash);
    fakes::setEepromCells(memories.eeprom);
}

// Another list, which must not notice.
ListKind otherKind(const Change& change) {
    return change.kind == ListKind::rally ? ListKind::fence : ListKind::rally;
}
Mission bystander(const Change& change) { return records(otherKind(change), 2, 99); }

struct Counts {
    int cuts = 0, old_list = 0, new_list = 0;
};

class PowerCuts : public testing::TestWithParam<bool> {
protected:
    static void newChips(bool slow) {
        fakes::reset();
        fakes::resetPageFlash();
        if (GetParam()) fakes::fitPageFlash();
        fakes::setEepromSlow(slow);
        fakes::setPageFlashSlow(slow);
    }

    static void prepare(const Change& change) {
        MissionStore store;
        ASSERT_EQ(open(store), Status::ok);
        // a few lists before, so that neither heads nor ring nor pages are fresh
        for (uint8_t count : {7, 3}) {
            const Mission earlier = records(change.kind, count, static_cast<uint8_t>(70 + count));
            ASSERT_EQ(upload(store, earlier, 2, change.kind), Status::ok);
        }
        ASSERT_EQ(upload(store, change.before, 2, change.kind), Status::ok);
        ASSERT_EQ(migrateToEeprom(store), Status::ok);
        ASSERT_EQ(upload(store, bystander(change), 2, otherKind(change)), Status::ok);
    }

    // Whether it is the new one; fails the test when it is neither.
    static bool isNew(MissionStore& store, const Change& change, int cut) {
        const Mission found = stored(store, change.kind);
        const bool is_new =
            found == change.after && store.ListStore::set(change.kind) == change.set_after;
        const bool is_old = found == change.before && store.ListStore::set(change.kind) == 2;
        EXPECT_TRUE(is_new || is_old) << change.name << ": a mixture after cut " << cut;
        return is_new;
    }

    // The one that boots, what it goes on with, and the one that boots after it.
    static void checkAfter(const Change& change, int cut, Counts& counts) {
        bool is_new = false;
        for (int boot = 0; boot < 2; ++boot) {
            MissionStore store;
            ASSERT_EQ(open(store), Status::ok) << change.name << ", cut " << cut;
            const bool now = isNew(store, change, cut);
            if (boot == 0) is_new = now;
            ASSERT_EQ(now, is_new) << "another one after another start";
            ASSERT_EQ(migrateToEeprom(store), Status::ok);
            ASSERT_EQ(isNew(store, change, cut), is_new);
            ASSERT_EQ(stored(store, otherKind(change)), bystander(change));
            restart();
        }
        ++(is_new ? counts.new_list : counts.old_list);
        if (cut % 13 != 0) return;
        MissionStore store;  // and life goes on
        ASSERT_EQ(open(store), Status::ok);
        ASSERT_EQ(upload(store, change.after, 2, change.kind), Status::ok);
        ASSERT_EQ(migrateToEeprom(store), Status::ok);
        ASSERT_EQ(stored(store, change.kind), change.after);
    }

    // Cuts at every step-th write until there is none left to cut.
    static void cut(const Change& change, int step, bool slow, Counts& counts) {
        newChips(slow);
        prepare(change);
        if (HasFatalFailure()) return;
        const Memories before = remember();
        for (int at = 0; !HasFatalFailure(); at += step, ++counts.cuts) {
            recall(before);
            MissionStore writer;
            ASSERT_EQ(open(writer), Status::ok);
            fakes::cutPowerAfter(static_cast<uint32_t>(at));
            (void)change.make(writer, change);
            if (!fakes::powerWasCut()) (void)migrateToEeprom(writer);
            const bool was_cut = fakes::powerWasCut();
            restart();
            if (!was_cut) break;
            checkAfter(change, at, counts);
        }
        MissionStore reader;
        ASSERT_EQ(open(reader), Status::ok);
        EXPECT_TRUE(isNew(reader, change, -1));
    }

    template <size_t count>
    static void cutAll(const Change (&changes)[count], int step, bool slow, Counts& sum) {
        for (const Change& change : changes) {
            Counts counts;
            cut(change, step, slow, counts);
            printf("  %-16s %5d cuts: %5d old, %5d new\n", change.name, counts.cuts,
                   counts.old_list, counts.new_list);
            sum.cuts += counts.cuts;
        }
    }

    static int cutEverything(int step, bool slow) {
        Counts sum;
        cutAll(kAnywhere, step, slow, sum);
        if (GetParam())
            cutAll(kFull, step, slow, sum);
        else
            cutAll(kBeside, step, slow, sum);
        printf("%d power cuts survived\n", sum.cuts);
        RecordProperty("cuts", sum.cuts);
        return sum.cuts;
    }
};

TEST_P(PowerCuts, in_every_write_leave_the_old_or_the_new_list) {
    EXPECT_GT(cutEverything(1, false), 4000);
}

// In the chips' own time, so that a byte and a page are in flight at once.
TEST_P(PowerCuts, in_slow_chips_leave_the_old_or_the_new_list) {
    EXPECT_GT(cutEverything(7, true), 600);
}

struct Draw {
    uint32_t state;
    uint32_t below(uint32_t limit) {
        state = state * 1664525u + 1013904223u;
        return (state >> 8) % limit;
    }
};

// The write in flight is torn, at any moment of a change and then again of the start after it.
TEST_P(PowerCuts, torn_ones_and_more_of_them_in_the_recovery_leave_the_old_or_the_new_list) {
    const char* wanted = std::getenv("STORAGE_CUTS");
    const int each = (wanted != nullptr ? std::atoi(wanted) : 900) / 9;
    Counts sum;
    Draw draw = {GetParam() ? 7u : 8u};
    const auto recover = [](uint32_t writes) {
        fakes::cutPowerAfter(writes);
        MissionStore store;
        (void)open(store);
        if (!fakes::powerWasCut()) (void)migrateToEeprom(store);
        const bool was_cut = fakes::powerWasCut();
        restart();
        return was_cut;
    };
    const auto cutOne = [&](const Change& change) {
        newChips(false);
        prepare(change);
        const Memories before = remember();
        uint32_t writes = 400;  // of the change; less as it turns out
        for (int n = 0; n < each && !HasFatalFailure(); ++n) {
            recall(before);
            fakes::setEepromSlow(n % 8 == 0);
            fakes::setPageFlashSlow(n % 8 == 0);
            fakes::tearWrites(draw.below(0xFFFFFF) + 1);
            const uint32_t at = draw.below(writes);
            MissionStore writer;
            ASSERT_EQ(open(writer), Status::ok);
            fakes::cutPowerAfter(at);
            (void)change.make(writer, change);
            if (!fakes::powerWasCut()) (void)migrateToEeprom(writer);
            if (!fakes::powerWasCut()) writes = std::max(at, 10u);
            restart();
            for (uint32_t again = draw.below(3); again > 0; --again)
                sum.cuts += recover(draw.below(n % 2 == 0 ? 40 : writes));
            ++sum.cuts;
            fakes::tearWrites(0);
            const bool one_more_fits = GetParam();
            checkAfter(change, one_more_fits ? n : 1, sum);
        }
    };
    for (const Change& change : kAnywhere) cutOne(change);
    cutOne(GetParam() ? kFull[2] : kBeside[0]);
    printf("%d torn power cuts: %d old, %d new\n", sum.cuts, sum.old_list, sum.new_list);
    RecordProperty("cuts", sum.cuts);
    EXPECT_GT(sum.old_list, each / 4);
    EXPECT_GT(sum.new_list, each / 4);
}

INSTANTIATE_TEST_SUITE_P(DataFlash, PowerCuts, testing::Bool(), [](const auto& row) {
    return row.param ? std::string("with") : std::string("without");
});

}  // namespace
