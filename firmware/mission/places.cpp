// SPDX-License-Identifier: GPL-3.0-or-later
// Where NAVs lie that are not flown yet.
#include "core/file_state.hpp"
#include "firmware/mission/command_table.hpp"
#include "firmware/mission/engine.hpp"
#include "firmware/mission/handlers.hpp"

namespace firmware {
namespace mission {

using namespace state;

namespace {

using core::Status;

struct NextPlace {
    uint8_t nav, generation;  // of which mission
    uint8_t at;               // the record to look at
};
core::FileState<NextPlace> next{};

uint8_t rowOfNav(const Record& record, ItemPosition position) {
    const uint8_t row = kCommandTable.find(missionSet(), record.id);
    const bool nav = row != ::mission::kNoRow && kCommandTable.kind(row) == ::mission::Class::nav &&
                     kCommandTable.valid(row, record, position) == 0;
    return nav ? row : ::mission::kNoRow;
}

}  // namespace

bool placeOfNav(const Record& record, ItemPosition position, geo::Position& place) {
    constexpr uint8_t kReturn = 0x14;
    const uint8_t row = rowOfNav(record, position);
    if (row == ::mission::kNoRow) return false;
    if (record.id == kReturn) {
        place = vehicle.home.position;
        return vehicle.home.set;
    }
    place = {record.p3, record.p4};
    return (kCommandTable.traits(row) & ::mission::kPlaced) != 0 &&
           (record.p3 != 0 || record.p4 != 0);
}

Status nextPlace(geo::Position& place) {
    const uint8_t nav = mission_engine.current();
    if (next.nav != nav || next.generation != mission_store.generation())
        next = {nav, mission_store.generation(), static_cast<uint8_t>(nav + 1)};
    for (uint8_t n = 0; n < kRecordsPerCall; ++n, ++next.at) {
        const ItemPosition position = {next.at, mission_store.count()};
        if (position.index >= position.count) return Status::bad_argument;
        uint8_t bytes[::mission::kRecordSize];
        const Status status = mission_store.read(position.index, bytes);
        if (status != Status::ok) return status;
        const Record record = ::mission::unpack(missionSet(), bytes);
        if (rowOfNav(record, position) == ::mission::kNoRow) continue;
        return placeOfNav(record, position, place) ? Status::ok : Status::bad_argument;
    }
    return Status::busy;
}

}  // namespace mission
}  // namespace firmware
