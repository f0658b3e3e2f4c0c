// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/store.hpp"

#include <string.h>

#include "storage/journal.hpp"

namespace parameters {
namespace {

using core::Status;

storage::Journal journal;
uint8_t waiting[kMaxRows / 8];  // one bit a row
bool any_waiting;
uint8_t next_to_load;
bool recovered;

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
    const Status status = storage::readSlot(table.slot(index), bits);
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
    if (!recovered) {
        const Status status = journal.recover();
        if (status != Status::ok) return status;
        recovered = true;
    }
    for (; next_to_load < table.count(); ++next_to_load) {
        const Status status = loadRow(table, next_to_load);
        if (status != Status::ok) return status;
    }
    next_to_load = 0;
    recovered = false;
    return Status::ok;
}

Status save(const Table& table, uint8_t index, float value) {
    return journal.write(table.slot(index), bitsOf(value));
}

Status forget(const Table& table, uint8_t index) { return storage::clearSlot(table.slot(index)); }

void saveLater(uint8_t index) {
    waiting[index / 8] = static_cast<uint8_t>(waiting[index / 8] | (1 << (index % 8)));
    any_waiting = true;
}

void saveWaiting(const Table& table) {
    journal.settle();
    if (!any_waiting) return;
    for (uint8_t i = 0; i < table.count(); ++i) {
        const uint8_t bit = static_cast<uint8_t>(1 << (i % 8));
        if ((waiting[i / 8] & bit) == 0) continue;
        if (save(table, i, table.value(i)) != Status::ok) return;
        waiting[i / 8] = static_cast<uint8_t>(waiting[i / 8] & ~bit);
    }
    any_waiting = false;
}

}  // namespace parameters
