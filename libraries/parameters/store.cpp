// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/store.hpp"

#include <string.h>

#include "core/based.hpp"
#include "core/file_state.hpp"
#include "storage/journal.hpp"

namespace parameters {
namespace {

using core::Status;

core::FileState<storage::Journal> journal{};

struct Progress {
    uint8_t waiting[kMaxRows / 8];  // one bit a row
    bool any_waiting;
    uint8_t next_to_load;
    bool recovered;
};
core::FileState<Progress> progress{};

uint32_t bitsOf(float value) {
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}
float floatOf(uint32_t bits) {
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

Status loadRow(const Table& table, uint8_t index) {
    uint32_t bits;
    const Status status = journal.read(table.slot(index), bits);
    if (status != Status::ok) return status;
    const float value = floatOf(bits);
    if (table.fits(index, value)) {  // blank EEPROM reads as NaN, which fits nothing
        table.assign(index, value);
    } else {
        table.assignInitial(index);
    }
    return Status::ok;
}

}  // namespace

Status load(const Table& table) {
    if (!progress.recovered) {
        const Status status = core::based<storage::Journal>(journal).recover();
        if (status != Status::ok) return status;
        progress.recovered = true;
    }
    for (; progress.next_to_load < table.count(); ++progress.next_to_load) {
        const Status status = loadRow(table, progress.next_to_load);
        if (status != Status::ok) return status;
    }
    progress.next_to_load = 0;
    progress.recovered = false;
    return Status::ok;
}

Status save(const Table& table, uint8_t index, float value) {
    return core::based<storage::Journal>(journal).write(table.slot(index), bitsOf(value));
}

Found found() { return journal.found(); }
Status trust() { return journal.trust(); }
bool takeWorn() { return journal.takeWorn(); }
void erased() { journal = storage::Journal(); }

Status forget(const Table& table, uint8_t index) { return storage::clearSlot(table.slot(index)); }

void saveLater(uint8_t index) {
    progress.waiting[index / 8] =
        static_cast<uint8_t>(progress.waiting[index / 8] | (1 << (index % 8)));
    progress.any_waiting = true;
}

void saveWaiting(const Table& table) {
    journal.applyPending();
    if (!progress.any_waiting) return;
    for (uint8_t i = 0; i < table.count(); ++i) {
        const uint8_t bit = static_cast<uint8_t>(1 << (i % 8));
        if ((progress.waiting[i / 8] & bit) == 0) continue;
        if (save(table, i, table.value(i)) != Status::ok) return;
        progress.waiting[i / 8] = static_cast<uint8_t>(progress.waiting[i / 8] & ~bit);
    }
    progress.any_waiting = false;
}

}  // namespace parameters
