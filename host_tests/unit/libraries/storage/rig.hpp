// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of noise, and a store taken through what the firmware does with it.
#pragma once
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "fakes/fakes.hpp"
#include "fakes/page_flash.hpp"
#include "storage/mission_store.hpp"

using core::Status;
using storage::ListKind;
using storage::MissionStore;
using Record = std::array<uint8_t, storage::kRecordSize>;
using Mission = std::vector<Record>;

inline Mission mission(uint8_t count, uint8_t seed) {
    Mission made(count);
    uint32_t random = seed * 2654435761u + 1;
    for (Record& record : made)
        for (uint8_t& byte : record)
            byte = static_cast<uint8_t>((random = random * 1664525u + 1013904223u) >> 24);
    return made;
}

// A list of another kind: the same noise, in shorter records.
inline Mission records(ListKind kind, uint8_t count, uint8_t seed) {
    Mission made = mission(count, seed);
    for (Record& record : made)
        for (size_t i = storage::shapeOf(kind).record_size; i < record.size(); ++i) record[i] = 0;
    return made;
}

template <class Call>
Status whileBusy(Call call) {
    for (int i = 0; i < 100000; ++i) {
        const Status status = call();
        if (status != Status::busy) return status;
        fakes::advance_ms(10);
    }
    return Status::timeout;
}

// The first that was wrong with any of the lists.
inline Status open(MissionStore& store) {
    Status found = Status::ok;
    for (;;) {
        ListKind which;
        const Status status = whileBusy([&] { return store.open(which); });
        if (found == Status::ok) found = status;
        if (status == Status::ok || status == Status::timeout) return found;
    }
}

inline Status upload(MissionStore& store, const Mission& mission, uint8_t set = 2,
                     ListKind kind = ListKind::mission) {
    const Status begun =
        whileBusy([&] { return store.begin(kind, static_cast<uint8_t>(mission.size()), set); });
    if (begun != Status::ok) return begun;
    for (const Record& record : mission) {
        const Status status = whileBusy([&] { return store.put(record.data()); });
        if (status != Status::ok) return status;
    }
    return whileBusy([&] { return store.commit(); });
}

// Replaces the records first..last by those of `with`.
inline Status partial(MissionStore& store, uint8_t first, uint8_t last, const Mission& with) {
    const uint8_t count = store.count();
    const Status begun = whileBusy([&] { return store.begin(count, store.set()); });
    if (begun != Status::ok) return begun;
    for (uint8_t i = 0; i < count; ++i) {
        const bool changed = i >= first && i <= last;
        const Status status =
            whileBusy([&] { return changed ? store.put(with[i].data()) : store.copy(); });
        if (status != Status::ok) return status;
    }
    return whileBusy([&] { return store.commit(); });
}

inline Status migrateToEeprom(MissionStore& store) {
    return whileBusy([&] { return store.migrateToEeprom(); });
}

inline Mission stored(MissionStore& store, ListKind kind = ListKind::mission) {
    Mission found(store.count(kind), Record{});
    for (uint8_t i = 0; i < found.size(); ++i)
        EXPECT_EQ(whileBusy([&] {
                      return kind == ListKind::mission ? store.read(i, found[i].data())
                                                       : store.read(kind, i, found[i].data());
                  }),
                  Status::ok);
    return found;
}

// As a reset or a power cut leaves the chips.
inline void restart() {
    fakes::restartPageFlash();
    fakes::restartEeprom();
}
