// SPDX-License-Identifier: GPL-3.0-or-later
// Single bits of the EEPROM that change by themselves, and cells that are worn out: whoever boots
// finds the list that was acknowledged, or says that it is lost. Never does an older one come back.
// STORAGE_BITS=1 flips every bit; without it every seventh, and all of the heads.
#include <cstdlib>

#include "rig.hpp"

namespace {

struct Found {
    int same = 0, mended = 0, lost = 0, wrong = 0;
};

class DamagedLists : public testing::TestWithParam<bool> {
protected:
    struct Lists {
        Mission mission, fence, rally;
        const Mission& of(ListKind kind) const {
            return kind == ListKind::mission ? mission : kind == ListKind::fence ? fence : rally;
        }
    };

    void SetUp() override {
        fakes::reset();
        fakes::resetPageFlash();
        if (GetParam()) fakes::fitPageFlash();
        MissionStore store;
        ASSERT_EQ(open(store), Status::ok);
        storeAll(store, before);
        storeAll(store, wanted);
        if (GetParam()) {
            ASSERT_EQ(migrateToEeprom(store), Status::ok);
        }
        cells = fakes::eepromCells();
        pages = fakes::flashPages();
    }

    static void storeAll(MissionStore& store, const Lists& lists) {
        for (const ListKind kind : {ListKind::mission, ListKind::fence, ListKind::rally})
            ASSERT_EQ(upload(store, lists.of(kind), 2, kind), Status::ok);
    }
    void recall() const {
        fakes::setFlashPages(pages);
        fakes::setEepromCells(cells);
    }

    // What the next start makes of the memories as they are.
    void boot(Found& found, const std::string& what) {
        MissionStore store;
        bool lost[storage::kListKinds] = {};
        for (Status status = Status::busy; status != Status::ok;) {
            ListKind which;
            status = whileBusy([&] { return store.open(which); });
            ASSERT_NE(status, Status::timeout);
            if (status != Status::ok) lost[static_cast<int>(which)] = true;
        }
        const Status migrated = migrateToEeprom(store);
        ListKind mended;
        const bool any_mended = store.takeMended(mended) || migrated != Status::ok;
        bool any_lost = false;
        for (const ListKind kind : {ListKind::mission, ListKind::fence, ListKind::rally}) {
            const Mission now = stored(store, kind);
            const bool is_lost = lost[static_cast<int>(kind)];
            any_lost = any_lost || is_lost;
            if (is_lost ? now.empty() : now == wanted.of(kind)) continue;
            ++found.wrong;
            ADD_FAILURE() << what << ": list " << static_cast<int>(kind) << " is another one";
        }
        ++(any_lost ? found.lost : any_mended ? found.mended : found.same);
    }

    static bool inHeads(uint16_t at) {
        const auto in = [at](storage::Region region) {
            return at >= region.begin && at < region.end();
        };
        return in(storage::kMissionHead) || in(storage::kFenceHead) || in(storage::kRallyHead);
    }
    static void print(const char* what, const Found& found) {
        printf("%s, %s a DataFlash: %d unharmed, %d mended, %d lost and reported, %d wrong\n", what,
               GetParam() ? "with" : "without", found.same, found.mended, found.lost, found.wrong);
    }

    const Lists before = {mission(25, 1), records(ListKind::fence, 5, 2),
                          records(ListKind::rally, 3, 3)};
    const Lists wanted = {mission(40, 4), records(ListKind::fence, 7, 5),
                          records(ListKind::rally, 4, 6)};
    std::vector<uint8_t> cells;
    fakes::FlashPages pages;
};

TEST_P(DamagedLists, are_mended_or_reported_whichever_bit_changes) {
    const bool all = std::getenv("STORAGE_BITS") != nullptr;
    Found found;
    for (uint16_t at = storage::kMissionHead.begin; at < hal::kEepromSize; ++at)
        for (int bit = 0; bit < 8; ++bit) {
            if (!all && !inHeads(at) && (at * 8 + bit) % 7 != 0) continue;
            recall();
            fakes::setEepromCell(at, static_cast<uint8_t>(fakes::eepromCell(at) ^ 1 << bit));
            boot(found, "bit " + std::to_string(bit) + " of " + std::to_string(at));
            if (found.wrong > 5) return;
        }
    print("bits", found);
    EXPECT_GT(found.mended, 0);
    EXPECT_EQ(found.lost == 0, GetParam()) << "the DataFlash has them";
}

// The damage is there before the list is written: what is acknowledged is found.
TEST_P(DamagedLists, are_not_acknowledged_on_worn_cells_that_lose_them) {
    const bool all = std::getenv("STORAGE_BITS") != nullptr;
    Found found;
    int refused = 0;
    for (uint16_t at = storage::kMissionHead.begin; at < storage::kRallyHead.end(); ++at)
        for (int bit = 0; bit < 8; ++bit)
            for (const bool high : {false, true}) {
                if (!all && (inHeads(at) ? bit % 3 != 0 : (at * 8 + bit) % 37 != 0)) continue;
                fakes::resetEeprom();
                recall();
                MissionStore store;
                ASSERT_EQ(open(store), Status::ok);
                fakes::wearEepromCell(at, static_cast<uint8_t>(1 << bit), high);
                const Mission list = mission(33, 9);
                const Status status = upload(store, list);
                restart();
                if (status != Status::ok) {
                    ++refused;
                    boot(found, "worn " + std::to_string(at));
                    continue;
                }
                MissionStore reader;
                ListKind which = ListKind::rally;
                const Status opened = whileBusy([&] { return reader.open(which); });
                if (opened != Status::ok && which == ListKind::mission) {
                    ++found.lost;
                    continue;
                }
                (void)open(reader);
                EXPECT_EQ(stored(reader), list) << at << ", " << bit;
            }
    printf("%d uploads refused\n", refused);
    print("worn cells", found);
}

INSTANTIATE_TEST_SUITE_P(DataFlash, DamagedLists, testing::Bool(), [](const auto& row) {
    return row.param ? std::string("with") : std::string("without");
});

}  // namespace
