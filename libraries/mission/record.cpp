// SPDX-License-Identifier: GPL-3.0-or-later
#include "mission/record.hpp"

#include "storage/bytes.hpp"

namespace mission {

using storage::get32;
using storage::put32;

void pack(Set set, const Record& record, uint8_t* to) {
    to[0] = record.id;
    if (set == Set::apm1) {
        to[1] = record.p1;
        put32(to + 2, static_cast<uint32_t>(record.p2));
    } else {
        to[1] = record.options;
        to[2] = record.p1;
        storage::put16(to + 3, static_cast<uint16_t>(record.p2));
        to[5] = static_cast<uint8_t>(record.p2 >> 16);
    }
    put32(to + 6, static_cast<uint32_t>(record.p3));
    put32(to + 10, static_cast<uint32_t>(record.p4));
}

Record unpack(Set set, const uint8_t* from) {
    Record record;
    record.id = from[0];
    if (set == Set::apm1) {
        record.options = 0;
        record.p1 = from[1];
        record.p2 = static_cast<int32_t>(get32(from + 2));
    } else {
        record.options = from[1];
        record.p1 = from[2];
        // bytes 2..5 as one integer hold p2 in their upper three: the shift brings its sign along
        record.p2 = static_cast<int32_t>(get32(from + 2)) >> 8;
    }
    record.p3 = static_cast<int32_t>(get32(from + 6));
    record.p4 = static_cast<int32_t>(get32(from + 10));
    return record;
}

}  // namespace mission
