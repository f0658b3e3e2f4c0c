// SPDX-License-Identifier: GPL-3.0-or-later
// Where the lists of fixed-size records lie. A list has a ring of records and two heads in EEPROM,
// and two areas of whole pages in the DataFlash; an extent says which records are the list.
#pragma once
#include <stdint.h>

#include "core/status.hpp"
#include "storage/eeprom_map.hpp"

namespace storage {

enum class ListKind : uint8_t { mission, fence, rally };
constexpr uint8_t kListKinds = 3;
constexpr uint8_t kLargestRecord = kRecordSize;

struct ListShape {
    uint16_t heads;
    uint16_t records;
    uint8_t record_size;
    uint8_t slots;
    uint8_t page;  // the first of area A; area B follows it
    uint8_t area_pages;
    uint8_t page_records;  // in a page; what is left of it stays unused
};
ListShape shapeOf(ListKind kind);

enum class Place : uint8_t { eeprom, flash_a, flash_b };

struct Extent {
    uint8_t first;  // slot in EEPROM; of a list in the DataFlash, where it will be copied to
    uint8_t count;
    uint8_t set;  // which kind of records; 0: there is no such list
    Place place;
    uint8_t generation;  // of the list: counts commits, not heads
    uint16_t sequence;   // of the head
    uint16_t crc;        // of the records
};

// What a list holds as one number: the same list has the same one on any board, an empty one has 0.
constexpr uint32_t listId(uint8_t set, uint8_t count, uint16_t crc) {
    return count == 0 ? 0 : uint32_t{set} << 24 | uint32_t{count} << 16 | crc;
}

// busy: in a later frame. unsupported: it lies in a DataFlash that is not there.
MUST_USE core::Status readRecord(ListKind kind, const Extent& extent, uint8_t index, uint8_t* to);
// To the EEPROM, or into the chip's buffer, from where storePage() brings it into the DataFlash.
MUST_USE core::Status writeRecord(ListKind kind, const Extent& extent, uint8_t index,
                                  const uint8_t* from);
MUST_USE core::Status storePage(ListKind kind, const Extent& extent, uint8_t page);

// Heads are written in turn, so that the older one gives way. One that is not whole has set 0.
struct Head {
    Extent extent;
    bool blank;
};
MUST_USE core::Status readHead(ListKind kind, uint8_t turn, Head& head);
MUST_USE core::Status writeHead(ListKind kind, const Extent& extent);
// ok: it reads as it was written. corrupt: it does not.
MUST_USE core::Status checkHead(ListKind kind, const Extent& extent);

inline bool newer(uint16_t a, uint16_t b) { return static_cast<int16_t>(a - b) > 0; }

}  // namespace storage
