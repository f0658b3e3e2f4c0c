// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/mission/item.hpp"

#include <math.h>

#include "core/maths.hpp"
#include "core/rom.hpp"
#include "core/seldom.hpp"
#include "firmware/mission/command_table.hpp"
#include "firmware/mission/forms.hpp"
#include "firmware/state/parameters.hpp"

namespace firmware {
namespace mission {

using namespace state;

namespace {

using ::mission::Record;
using ::mission::Set;

// https://mavlink.io/en/messages/common.html#MAV_FRAME
enum Frame : uint8_t {
    kGlobal = 0,
    kMission = 2,
    kGlobalRelative = 3,
    kGlobalInt = 5,
    kGlobalRelativeInt = 6,
    kGlobalTerrain = 10,
};

// Out of what an int32 holds becomes the end of it, which no field takes.
SELDOM int32_t whole(float value) {
    if (!(fabsf(value) < 2147483520.0f)) return core::isNegative(value) ? INT32_MIN : INT32_MAX;
    return core::rounded(value);
}

int32_t field(const Record& record, uint8_t number) {
    const int32_t fields[] = {record.p1, record.p2, record.p3, record.p4};
    return fields[number];
}
bool setField(Record& record, uint8_t number, int32_t value) {
    switch (number) {
        case 0:
            record.p1 = static_cast<uint8_t>(value);
            return value >= 0 && value <= 255;
        case 1:
            record.p2 = value;
            break;
        case 2:
            record.p3 = value;
            break;
        default:
            record.p4 = value;
            break;
    }
    return value != INT32_MIN && value != INT32_MAX;
}

// To the centimetre; of a place below or above the globe's air nothing fits.
MissionResult encodeAltitude(const MissionItem& item, Record& record) {
    if (!(fabsf(item.z) <= 83886.0f)) return wrong(7);
    // in two steps: a float has no room for a hundredth beyond 1,300 m otherwise
    const int32_t metres = static_cast<int32_t>(item.z);
    record.p2 = metres * 100 + core::inHundredths(item.z - static_cast<float>(metres));
    return kFine;
}

bool relativeFrame(uint8_t frame) {
    return frame == kGlobalRelative || frame == kGlobalRelativeInt;
}
bool knownFrame(uint8_t frame) {
    return relativeFrame(frame) || frame == kGlobal || frame == kGlobalInt || frame == kMission;
}

// Does not fit: the answer names the parameter that p2 came from.
MissionResult layoutHolds(Set set, const Record& record, const FormRow& form) {
    if (::mission::fits(set, record)) return kFine;
    if ((form.parts & kAltitude) != 0) return wrong(7);
    return form.from[1] != 0 ? wrong(form.from[1]) : MissionResult::invalid;
}

// Which parameter is a radius whose sign is the direction; 0: none.
uint8_t radiusIn(uint8_t parts) {
    if ((parts & kDirection) != 0) return 3;
    return (parts & kDirectionInTwo) != 0 ? 2 : 0;
}

MissionResult encodeDirection(const float* parameter, uint8_t radius, Record& record,
                              EncodeWarnings& warnings) {
    const float radius_m = orZero(parameter[radius]);
    if (!isfinite(radius_m)) return wrong(radius);
    if (core::isNegative(radius_m)) record.options |= ::mission::kCounterClockwise;
    if (fabsf(radius_m) > 1) warnings.dropped = true;
    return kFine;
}

MissionResult encodeApm2(const MissionItem& item, const float* parameter, const FormRow& form,
                         Record& record, EncodeWarnings& warnings) {
    uint8_t used = form.special_uses;
    for (uint8_t i = 0; i < 4; ++i) {
        const uint8_t from = form.from[i];
        if (from == 0) continue;
        used = static_cast<uint8_t>(used | use(from));
        const float value = orZero(parameter[from]);
        const int32_t stored = whole(value);
        if (!setField(record, i, stored)) return wrong(from);
        flagRounding(value, static_cast<float>(stored), warnings);
    }
    const uint8_t radius = radiusIn(form.parts);
    if (radius != 0) {
        used = static_cast<uint8_t>(used | use(radius));
        const MissionResult result = encodeDirection(parameter, radius, record, warnings);
        if (result != kFine) return result;
    }
    if ((form.parts & kNumberInAltitude) != 0 && !setField(record, 0, whole(orZero(item.z))))
        return wrong(7);
    if (form.encode != nullptr) {
        const MissionResult result = form.encode(parameter, record, warnings);
        if (result != kFine) return result;
    }
    for (uint8_t i = 1; i <= 4; ++i)
        if ((used & use(i)) == 0 && !core::isZero(orZero(parameter[i]))) warnings.dropped = true;
    const bool alone = form.parts == kAltitude || form.parts == kNumberInAltitude;
    if (alone && (item.x != 0 || item.y != 0)) warnings.dropped = true;
    return kFine;
}

// The record's own numbers; what a float cannot carry exactly is refused.
MissionResult encodeApm1(const float* parameter, uint8_t fields, Record& record) {
    constexpr float kExact = 16777216.0f;  // 2 to the 24th
    for (uint8_t i = 0; i < fields; ++i) {
        const float value = orZero(parameter[i + 1]);
        if (!(fabsf(value) <= kExact)) return wrong(i + 1);
        const int32_t stored = core::rounded(value);
        if (static_cast<float>(stored) != value || !setField(record, i, stored))
            return wrong(i + 1);
    }
    return kFine;
}

bool isNav(uint8_t row) { return kCommandTable.kind(row) == ::mission::Class::nav; }

FormRow formOf(Set set, uint8_t row) {
    FormRow form = formRow(kCommandTable.form(row));
    if (set == Set::apm1) form.parts = isNav(row) || form.parts == kPlace ? kPlace : 0;
    return form;
}

}  // namespace

// MAV_CMDs that are no byte, from this id on.
namespace {

constexpr uint8_t kFirstLarge = 0xF0;
constexpr uint16_t kLarge[] ROM = {530, 2000, 2001, 600, 2500, 2501};

uint16_t commandOf(uint8_t id) {
    const uint8_t large = static_cast<uint8_t>(id - kFirstLarge);
    return large < core::count(kLarge) ? core::romRead(kLarge[large]) : id;
}

}  // namespace

uint8_t idOf(uint16_t command) {
    for (uint8_t i = 0; i < core::count(kLarge); ++i)
        if (core::romRead(kLarge[i]) == command) return kFirstLarge + i;
    return command < kFirstLarge ? static_cast<uint8_t>(command) : ::mission::kNoId;
}

MissionResult encodeItem(Set set, ::mission::ItemPosition position, const MissionItem& item,
                         Record& record, EncodeWarnings& warnings) {
    const uint8_t id = idOf(item.command);
    const uint8_t row = kCommandTable.find(set, id);
    if (row == ::mission::kNoRow) return MissionResult::unsupported;
    if (!knownFrame(item.frame)) return MissionResult::unsupported_frame;
    const bool relative = relativeFrame(item.frame);
    const FormRow form = formOf(set, row);
    record = {};
    record.id = id;
    const float parameter[] = {0, item.param1, item.param2, item.param3, item.param4};
    MissionResult result;
    if (set == Set::apm2) {
        if (relative) record.options = ::mission::kRelativeAltitude;
        result = encodeApm2(item, parameter, form, record, warnings);
    } else {
        // home lies above the sea
        if (isNav(row) && position.index != 0 && relative != (parameters.altitude_absolute == 0))
            return MissionResult::unsupported_frame;
        result = encodeApm1(parameter, form.parts == kPlace ? 1 : 4, record);
    }
    if (result != kFine) return result;
    if ((form.parts & kAltitude) != 0) {
        result = encodeAltitude(item, record);
        if (result != kFine) return result;
    }
    if (form.parts >= kPlace && (form.parts & kPlace) == kPlace) {
        record.p3 = item.x;
        record.p4 = item.y;
    }
    result = layoutHolds(set, record, form);
    if (result != kFine) return result;
    return static_cast<MissionResult>(kCommandTable.valid(row, record, position));
}

namespace {

uint8_t frameOf(Set set, uint8_t row, const Record& record, uint8_t index, uint8_t parts) {
    if (set == Set::apm1) {
        if (isNav(row) && index != 0)
            return parameters.altitude_absolute != 0 ? kGlobal : kGlobalRelative;
        return parts == kPlace ? kGlobal : kMission;
    }
    if ((record.options & ::mission::kAboveTerrain) != 0) return kGlobalTerrain;
    if ((record.options & ::mission::kRelativeAltitude) != 0) return kGlobalRelative;
    return (parts & kAltitude) != 0 ? kGlobal : kMission;
}

}  // namespace

void decodeItem(Set set, uint8_t index, const Record& record, MissionItem& item) {
    item = {};
    item.command = commandOf(record.id);
    item.frame = kMission;
    const uint8_t row = kCommandTable.find(set, record.id);
    if (row == ::mission::kNoRow) return;
    const FormRow form = formOf(set, row);
    item.frame = frameOf(set, row, record, index, form.parts);
    float parameter[5] = {};
    if (set == Set::apm1) {
        const uint8_t fields = form.parts == kPlace ? 1 : 4;
        for (uint8_t i = 0; i < fields; ++i)
            parameter[i + 1] = static_cast<float>(field(record, i));
    } else {
        for (uint8_t i = 0; i < 4; ++i)
            if (form.from[i] != 0) parameter[form.from[i]] = static_cast<float>(field(record, i));
        const uint8_t radius = radiusIn(form.parts);
        if (radius != 0 && (record.options & ::mission::kCounterClockwise) != 0)
            parameter[radius] = -1;
        if ((form.parts & kNumberInAltitude) != 0) item.z = core::real(record.p1);
        if (form.decode != nullptr) form.decode(record, parameter);
    }
    item.param1 = parameter[1];
    item.param2 = parameter[2];
    item.param3 = parameter[3];
    item.param4 = parameter[4];
    if ((form.parts & kAltitude) != 0) item.z = static_cast<float>(record.p2) / 100;
    if ((form.parts & kPlace) == kPlace) {
        item.x = record.p3;
        item.y = record.p4;
    }
}

}  // namespace mission
}  // namespace firmware
