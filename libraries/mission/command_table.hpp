// SPDX-License-Identifier: GPL-3.0-or-later
// The shape of a command's row and the proofs every table of rows must pass. The rows themselves
// are the firmware's: firmware/mission/command_table.cpp.
#pragma once
#include "core/rom.hpp"
#include "mission/record.hpp"

namespace mission {

constexpr uint8_t kNoId = 0;
constexpr uint8_t kNoRow = 0xFF;

// nav: must finish before the next of its class. condition: has an end, may be cut short.
// action: done at once. jump: an action on the queue itself.
enum class Class : uint8_t { nav, condition, action, jump };

enum class Progress : uint8_t { running, done };

enum CommandFlag : uint8_t {
    kPlaced = 1,       // latitude and longitude 0 mean: where the airplane is
    kEndsNowhere = 2,  // the next leg begins at the airplane, not at this command's place
    kEndsFlight = 4,   // only a command that begins a flight can follow
    kBeginsFlight = 8,
    kArduPlaneExtension = 16,  // in neither of the two sets' documents
};

struct LegStart {
    bool resumed;    // it was being flown before, and goes on
    bool from_here;  // the leg begins at the airplane; else at the place of the last one finished
};

struct ItemPosition {  // where in which mission a record stands
    uint8_t index;
    uint8_t count;
};

struct Jump {
    uint8_t target;
    int16_t times;  // kForEver: no count
};
constexpr int16_t kForEver = -1;

using Valid = uint8_t (*)(const Record&,
                          ItemPosition);  // 0: in range; else the answer for the ground
using Begin = void (*)(const Record&, LegStart);
using Act = void (*)(const Record&);
using Check = Progress (*)(const Record&);
using Target = Jump (*)(const Record&);

struct Row {
    uint8_t apm1_id;  // kNoId: the set has no such command
    uint8_t apm2_id;
    Class kind;
    uint8_t traits;
    uint8_t form;  // how it travels on the ground link: the firmware's numbering
    Valid valid;
    Begin begin;    // nav
    Act act;        // condition, action
    Check check;    // nav, condition
    Target target;  // jump
};

// A row is written with the word for its class, so a NAV or CONDITION cannot be written without
// its check, nor an action with one.
constexpr Row nav(uint8_t apm1_id, uint8_t apm2_id, uint8_t form, Valid valid, Begin begin,
                  Check check, uint8_t traits) {
    return {apm1_id, apm2_id, Class::nav, traits, form, valid, begin, nullptr, check, nullptr};
}
constexpr Row condition(uint8_t apm1_id, uint8_t apm2_id, uint8_t form, Valid valid, Act act,
                        Check check) {
    return {apm1_id, apm2_id, Class::condition, 0, form, valid, nullptr, act, check, nullptr};
}
constexpr Row action(uint8_t apm1_id, uint8_t apm2_id, uint8_t form, Valid valid, Act act) {
    return {apm1_id, apm2_id, Class::action, 0, form, valid, nullptr, act, nullptr, nullptr};
}
constexpr Row jump(uint8_t apm1_id, uint8_t apm2_id, uint8_t form, Valid valid, Target target) {
    return {apm1_id, apm2_id, Class::jump, 0, form, valid, nullptr, nullptr, nullptr, target};
}

constexpr Row beyond(Row row) {
    row.traits = static_cast<uint8_t>(row.traits | kArduPlaneExtension);
    return row;
}

template <size_t N>
constexpr bool idsAreUnique(const Row (&rows)[N]) {
    for (size_t i = 0; i < N; ++i)
        for (size_t j = i + 1; j < N; ++j) {
            if (rows[i].apm1_id != kNoId && rows[i].apm1_id == rows[j].apm1_id) return false;
            if (rows[i].apm2_id != kNoId && rows[i].apm2_id == rows[j].apm2_id) return false;
        }
    return true;
}

// Only a placed NAV can be asked for its place, and one that ends a flight leaves the airplane
// where it is.
template <size_t N>
constexpr bool traitsMakeSense(const Row (&rows)[N]) {
    for (size_t i = 0; i < N; ++i)
        if (rows[i].kind != Class::nav && (rows[i].traits & ~kArduPlaneExtension) != 0)
            return false;
    return true;
}

// How many ids of the set its document has (traits 0), or are beyond it (kArduPlaneExtension).
template <size_t N>
constexpr uint8_t idsIn(const Row (&rows)[N], Set set, uint8_t traits) {
    uint8_t found = 0;
    for (size_t i = 0; i < N; ++i)
        found = static_cast<uint8_t>(
            found + ((rows[i].traits & kArduPlaneExtension) == traits &&
                     (set == Set::apm1 ? rows[i].apm1_id : rows[i].apm2_id) != kNoId));
    return found;
}

struct Table {
    const Row* rows;  // in flash
    uint8_t count;

    uint8_t find(Set set, uint8_t id) const {
        if (id == kNoId) return kNoRow;
        const uint8_t* key = set == Set::apm1 ? &rows->apm1_id : &rows->apm2_id;
        for (uint8_t i = 0; i < count; ++i) {
            if (core::romRead(*key) == id) return i;
            key += sizeof(Row);
        }
        return kNoRow;
    }
    // Not inlined: the product that it takes stands in a dozen places.
    __attribute__((noinline)) const Row& at(uint8_t row) const { return rows[row]; }
    Class kind(uint8_t row) const { return core::romRead(at(row).kind); }
    uint8_t traits(uint8_t row) const { return core::romRead(at(row).traits); }
    uint8_t form(uint8_t row) const { return core::romRead(at(row).form); }
    Begin begin(uint8_t row) const { return core::romRead(at(row).begin); }
    Act act(uint8_t row) const { return core::romRead(at(row).act); }
    Check check(uint8_t row) const { return core::romRead(at(row).check); }
    Target target(uint8_t row) const { return core::romRead(at(row).target); }
    uint8_t id(Set set, uint8_t row) const {
        return core::romRead(set == Set::apm1 ? rows[row].apm1_id : rows[row].apm2_id);
    }
    uint8_t valid(uint8_t row, const Record& record, ItemPosition position) const {
        return core::romRead(at(row).valid)(record, position);
    }
};

}  // namespace mission
