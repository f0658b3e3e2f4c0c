// SPDX-License-Identifier: GPL-3.0-or-later
// The shape of a parameter row and the proofs on a table of them. A parameter is stored at its
// slot number, for ever: rows may be sorted or renamed, slots may not.
#pragma once
#include <stddef.h>
#include <stdint.h>

#include "core/rom.hpp"
#include "core/status.hpp"

namespace parameters {

enum class Type : uint8_t { int8 = 2, int16 = 4, int32 = 6, real32 = 9 };  // MAV_PARAM_TYPE

template <class T>
struct TypeOf;
template <>
struct TypeOf<int8_t> {
    static constexpr Type value = Type::int8;
};
template <>
struct TypeOf<int16_t> {
    static constexpr Type value = Type::int16;
};
template <>
struct TypeOf<int32_t> {
    static constexpr Type value = Type::int32;
};
template <>
struct TypeOf<float> {
    static constexpr Type value = Type::real32;
};

// an element of an array is seen by decltype as a reference
template <class T>
struct TypeOf<T&> : TypeOf<T> {};

constexpr uint8_t kNameSize = 16;

struct Row {
    uint8_t slot;
    char name[kNameSize + 1];  // MAVLink allows 16
    Type type;
    uint16_t offset;  // of the field in the struct in RAM
    float initial, lowest, highest;
};

// One row for a field of Owner; the type follows from the field.
#define PARAMETER(slot, name, Owner, field, initial, lowest, highest)               \
    {                                                                               \
        slot, name, ::parameters::TypeOf<decltype(Owner::field)>::value,            \
            static_cast<uint16_t>(offsetof(Owner, field)), initial, lowest, highest \
    }

template <size_t N>
constexpr bool slotsAreUnique(const Row (&rows)[N]) {
    bool taken[256] = {};
    for (size_t i = 0; i < N; ++i) {
        if (taken[rows[i].slot]) return false;
        taken[rows[i].slot] = true;
    }
    return true;
}

constexpr bool same(const char* a, const char* b) {
    while (*a != 0 && *a == *b) {
        ++a;
        ++b;
    }
    return *a == *b;
}

template <size_t N>
constexpr bool namesAreUnique(const Row (&rows)[N]) {
    for (size_t i = 0; i < N; ++i)
        for (size_t j = 0; j < i; ++j)
            if (same(rows[i].name, rows[j].name)) return false;
    return true;
}

template <size_t N>
constexpr bool initialsAreInRange(const Row (&rows)[N]) {
    for (size_t i = 0; i < N; ++i)
        if (!(rows[i].initial >= rows[i].lowest && rows[i].initial <= rows[i].highest))
            return false;
    return true;
}

struct PackedRow {
    uint16_t field;  // the type in the highest four bits, the field's offset below
    uint8_t slot;
    uint8_t initial, lowest, highest;  // places in the pool
};

// A table of packed rows (packed.hpp) over one struct of fields. It lies in flash itself: ROM.
class Table {
public:
    template <class Packed>
    constexpr Table(const Packed& packed, void* fields)
        : rows_(packed.row),
          groups_(packed.group),
          letters_(packed.letter),
          numbers_(packed.number),
          count_(core::count(packed.row)),
          fields_(fields) {}

    uint8_t count() const { return core::romRead(count_); }
    uint8_t slot(uint8_t index) const;
    Type type(uint8_t index) const;
    void name(uint8_t index, char (&to)[kNameSize]) const;  // padded with zeros
    float value(uint8_t index) const;

    bool findName(const char (&name)[kNameSize], uint8_t& index) const;
    bool findSlot(uint8_t slot, uint8_t& index) const;

    // Finite and in the row's range.
    bool fits(uint8_t index, float value) const;
    float initial(uint8_t index) const;
    float lowest(uint8_t index) const;
    float highest(uint8_t index) const;
    // Assigns, whole numbers rounded; returns what the field now holds. The value must fit.
    float assign(uint8_t index, float value) const;
    void assignInitial(uint8_t index) const { assign(index, initial(index)); }

private:
    const PackedRow& row(uint8_t index) const { return core::romRead(rows_)[index]; }
    float number(uint8_t place) const;
    uint8_t* field(uint8_t index) const;
    const uint8_t* letters(uint8_t index) const;

    const PackedRow* rows_;
    const uint16_t* groups_;
    const uint8_t* letters_;
    const float* numbers_;
    uint8_t count_;
    void* fields_;
};

}  // namespace parameters
