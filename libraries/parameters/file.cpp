// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/file.hpp"

#include <string.h>

namespace parameters {
namespace {

struct Part {
    uint8_t size;
    uint8_t bytes[kLongestEntry];
};

void makeHeader(const Table& table, Part& part) {
    const uint16_t header[] = {kFileMagic, table.count(), table.count()};
    static_assert(sizeof header == kFileHeader, "three numbers");
    memcpy(part.bytes, header, sizeof header);
    part.size = sizeof header;
}

// `name` is that of the row before, and becomes this one's.
void makeEntry(const Table& table, uint8_t row, char (&name)[kNameSize], Part& part) {
    char before[kNameSize];
    memcpy(before, name, sizeof before);
    table.name(row, name);
    const uint8_t common = commonLetters(name, before);
    const uint8_t letters = static_cast<uint8_t>(lengthOf(name) - common);
    // MAV_PARAM_TYPE is 2, 4, 6 and 9
    part.bytes[0] = static_cast<uint8_t>(static_cast<uint8_t>(table.type(row)) / 2);
    part.bytes[1] = static_cast<uint8_t>((letters - 1) << 4 | common);
    memcpy(part.bytes + kEntryHead, name + common, letters);
    part.size = static_cast<uint8_t>(kEntryHead + letters);
    part.size = static_cast<uint8_t>(part.size + table.copyValue(row, part.bytes + part.size));
}

}  // namespace

core::Status readFile(const Table& table, FileCursor& cursor, uint16_t offset, uint8_t* to,
                      uint8_t& size) {
    constexpr uint8_t kPassedAtOnce = 8;  // entries before the offset: half a millisecond
    if (offset < cursor.at) cursor = {};
    char name[kNameSize] = {};
    if (cursor.number > 1) table.name(static_cast<uint8_t>(cursor.number - 2), name);
    const uint8_t wanted = size;
    uint8_t passed = 0;
    for (size = 0; size < wanted && cursor.number <= table.count(); ++cursor.number) {
        Part part;
        if (cursor.number == 0)
            makeHeader(table, part);
        else
            makeEntry(table, static_cast<uint8_t>(cursor.number - 1), name, part);
        const uint16_t skipped = static_cast<uint16_t>(offset + size - cursor.at);
        if (skipped >= part.size) {
            if (++passed > kPassedAtOnce) return core::Status::busy;
        } else {
            uint8_t copied = static_cast<uint8_t>(part.size - skipped);
            const bool whole = copied <= wanted - size;
            if (!whole) copied = static_cast<uint8_t>(wanted - size);
            memcpy(to + size, part.bytes + skipped, copied);
            size = static_cast<uint8_t>(size + copied);
            if (!whole) break;
        }
        cursor.at = static_cast<uint16_t>(cursor.at + part.size);
    }
    return core::Status::ok;
}

}  // namespace parameters
