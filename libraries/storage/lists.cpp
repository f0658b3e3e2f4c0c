// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/lists.hpp"

#include <string.h>

#include "core/crc.hpp"
#include "core/rom.hpp"
#include "core/seldom.hpp"
#include "hal/page_flash.hpp"
#include "storage/bytes.hpp"

namespace storage {
namespace {

using core::Status;

constexpr uint16_t kSmallestPage = 512;
constexpr uint8_t pageRecords(uint8_t size) { return static_cast<uint8_t>(kSmallestPage / size); }
constexpr uint8_t areaPages(uint8_t size, uint8_t slots) {
    return static_cast<uint8_t>((slots + pageRecords(size) - 1) / pageRecords(size));
}
constexpr ListShape shape(Region heads, Region records, uint8_t size, uint8_t slots, uint8_t page) {
    return {heads.begin,      records.begin, size, slots, page, areaPages(size, slots),
            pageRecords(size)};
}
constexpr uint8_t nextPage(const ListShape& list) {
    return static_cast<uint8_t>(list.page + 2 * list.area_pages);
}

constexpr ListShape kMissionList = shape(kMissionHead, kMission, kRecordSize, kRecordSlots, 0);
constexpr ListShape kFenceList =
    shape(kFenceHead, kFence, kFenceSize, kFencePoints, nextPage(kMissionList));
constexpr ListShape kRallyList =
    shape(kRallyHead, kRally, kRallySize, kRallyPoints, nextPage(kFenceList));
static_assert(nextPage(kRallyList) <= hal::kFlashMissionPages, "the lists' pages are too few");
constexpr ListShape kLists[kListKinds] ROM = {kMissionList, kFenceList, kRallyList};

// A head: mark, layout version, sequence, first slot, count, set, place, CRC of the records, heads
// written since the list changed, spare, CRC of the head. What layout 1 did not know yet is 0 in
// its heads, which says: in EEPROM, and one head a change.
constexpr uint8_t kHeadMark = 0x4D;
enum Offset : uint8_t {
    kTraceAt = 0,
    kVersionAt = 1,
    kSequenceAt = 2,
    kFirstAt = 4,
    kCountAt = 5,
    kSetAt = 6,
    kPlaceAt = 7,
    kRecordsCrcAt = 8,
    kUnchangedAt = 10,
    kHeadCrcAt = kHeadSize - 2,
};

bool allOnes(const uint8_t* bytes, uint8_t size) {
    while (size-- > 0)
        if (*bytes++ != 0xFF) return false;
    return true;
}

uint16_t headAddress(const ListShape& list, uint8_t turn) {
    return static_cast<uint16_t>(list.heads + (turn & 1) * kHeadSize);
}

uint16_t slotAddress(const ListShape& list, const Extent& extent, uint8_t index) {
    uint16_t slot = static_cast<uint16_t>(extent.first + index);
    if (slot >= list.slots) slot = static_cast<uint16_t>(slot - list.slots);
    return static_cast<uint16_t>(list.records + slot * list.record_size);
}

uint16_t areaPage(const ListShape& list, const Extent& extent) {
    return extent.place == Place::flash_a ? list.page
                                          : static_cast<uint16_t>(list.page + list.area_pages);
}

void decodeHead(const ListShape& list, const uint8_t* head, Extent& extent) {
    extent.first = head[kFirstAt];
    extent.count = head[kCountAt];
    extent.set = head[kSetAt];
    extent.place = static_cast<Place>(head[kPlaceAt]);
    extent.sequence = get16(head + kSequenceAt);
    extent.crc = get16(head + kRecordsCrcAt);
    extent.generation = static_cast<uint8_t>(extent.sequence - head[kUnchangedAt]);
    const bool whole = head[kTraceAt] == kHeadMark && head[kVersionAt] == kLayoutVersion &&
                       extent.first < list.slots && extent.count <= list.slots &&
                       head[kPlaceAt] <= static_cast<uint8_t>(Place::flash_b) &&
                       get16(head + kHeadCrcAt) == core::crc16(core::kCrcStart, head, kHeadCrcAt);
    if (!whole) extent.set = 0;
}

void encodeHead(const Extent& extent, uint8_t (&head)[kHeadSize]) {
    memset(head, 0, sizeof head);
    head[kTraceAt] = kHeadMark;
    head[kVersionAt] = kLayoutVersion;
    put16(head + kSequenceAt, extent.sequence);
    head[kFirstAt] = extent.first;
    head[kCountAt] = extent.count;
    head[kSetAt] = extent.set;
    head[kPlaceAt] = static_cast<uint8_t>(extent.place);
    put16(head + kRecordsCrcAt, extent.crc);
    head[kUnchangedAt] = static_cast<uint8_t>(extent.sequence - extent.generation);
    put16(head + kHeadCrcAt, core::crc16(core::kCrcStart, head, kHeadCrcAt));
}

uint16_t addressOf(ListKind kind, const Extent& extent) {
    return headAddress(shapeOf(kind), static_cast<uint8_t>(extent.sequence));
}

}  // namespace

SELDOM ListShape shapeOf(ListKind kind) {
    return core::romRead(kLists[static_cast<uint8_t>(kind)]);
}

Status readRecord(ListKind kind, const Extent& extent, uint8_t index, uint8_t* to) {
    if (index >= extent.count) return Status::bad_argument;
    const ListShape list = shapeOf(kind);
    if (extent.place == Place::eeprom)
        return hal::eepromRead(slotAddress(list, extent, index), to, list.record_size);
    if (!hal::flashKnown()) return Status::busy;
    const uint8_t page = index / list.page_records;
    const uint8_t in_page = static_cast<uint8_t>(index - page * list.page_records);
    return hal::flashRead(static_cast<uint16_t>(areaPage(list, extent) + page),
                          static_cast<uint16_t>(in_page * list.record_size), to, list.record_size);
}

Status writeRecord(ListKind kind, const Extent& extent, uint8_t index, const uint8_t* from) {
    const ListShape list = shapeOf(kind);
    if (extent.place == Place::eeprom)
        return hal::eepromWrite(slotAddress(list, extent, index), from, list.record_size);
    const uint8_t in_page = index % list.page_records;
    return hal::flashFill(hal::FlashUser::mission,
                          static_cast<uint16_t>(in_page * list.record_size), from,
                          list.record_size);
}

Status storePage(ListKind kind, const Extent& extent, uint8_t page) {
    return hal::flashStore(hal::FlashUser::mission,
                           static_cast<uint16_t>(areaPage(shapeOf(kind), extent) + page));
}

Status readHead(ListKind kind, uint8_t turn, Head& head) {
    const ListShape list = shapeOf(kind);
    uint8_t bytes[kHeadSize];
    const Status status = hal::eepromRead(headAddress(list, turn), bytes, sizeof bytes);
    if (status != Status::ok) return status;
    head.blank = allOnes(bytes, sizeof bytes);
    decodeHead(list, bytes, head.extent);
    return Status::ok;
}

Status writeHead(ListKind kind, const Extent& extent) {
    uint8_t head[kHeadSize];
    encodeHead(extent, head);
    return hal::eepromWrite(addressOf(kind, extent), head, sizeof head);
}

Status checkHead(ListKind kind, const Extent& extent) {
    uint8_t wanted[kHeadSize], found[kHeadSize];
    encodeHead(extent, wanted);
    const Status status = hal::eepromRead(addressOf(kind, extent), found, sizeof found);
    if (status != Status::ok) return status;
    return memcmp(wanted, found, sizeof found) == 0 ? Status::ok : Status::corrupt;
}

}  // namespace storage
