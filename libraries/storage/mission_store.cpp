// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/mission_store.hpp"

#include <string.h>

namespace storage {

using core::Status;

Status MissionStore::read(uint8_t index, uint8_t* to) {
    const Ahead& ahead = ahead_[index % kAheads];
    if (ahead.index_1 != index + 1 || index >= count()) return read(ListKind::mission, index, to);
    memcpy(to, ahead.record, kRecordSize);
    return Status::ok;
}

void MissionStore::readAhead(uint8_t index) {
    for (uint8_t i = 0; i < kAheads && index < count(); ++i, ++index) {
        Ahead& ahead = ahead_[index % kAheads];
        if (ahead.index_1 == index + 1) continue;
        uint8_t record[kRecordSize];
        if (read(ListKind::mission, index, record) != Status::ok) return;
        memcpy(ahead.record, record, sizeof record);
        ahead.index_1 = static_cast<uint8_t>(index + 1);
    }
}

Status MissionStore::commit() {
    const Status status = ListStore::commit();
    if (status == Status::ok)
        for (Ahead& ahead : ahead_) ahead.index_1 = 0;
    return status;
}

}  // namespace storage
