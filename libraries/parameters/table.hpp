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

// No row has one of these slots.
template <size_t N, size_t M>
constexpr bool slotsAvoid(const Row (&rows)[N], const uint8_t (&retired)[M]) {
    for (size_t i = 0; i < N; ++i)
        for (size_t j = 0; j < M; ++j)
            if (rows[i].slot == retired[j]) return false;
    return true;
}

// The lowest slot that no row has and that is not retired; 256: there is none.
template <size_t N, size_t M>
constexpr uint16_t lowestFreeSlot(const Row (&rows)[N], const uint8_t (&retired)[M]) {
    bool taken[256] = {};
    for (size_t i = 0; i < N; ++i) taken[rows[i].slot] = true;
    for (size_t i = 0; i < M; ++i) taken[retired[i]] = true;
    uint16_t slot = 0;
    while (slot < 256 && taken[slot]) ++slot;
    return slot;
}

constexpr bool same(const char* a, const char* b) {
    while (*a != 0 && *a == *b) {
        ++a;
        ++b;
    }
    return *a == *b;
}

template <size_t N>
constexpr bool initialsAreInRange(const Row (&rows)[N]) {
    for (size_t i = 0; i < N; ++i)
        if (!(rows[i].initial >= rows[i].lowest && rows[i].initial <= rows[i].highest))
            return false;
    return true;
}

// A table of rows over one struct of fields. Rows and table lie in flash: ROM.
class Table {
public:
    template <size_t N>
    constexpr Table(const Row (&rows)[N], void* fields)
        : rows_(rows), count_(static_cast<uint8_t>(N)), fields_(fields) {
        static_assert(N <= 255, "rows are numbered by a byte");
    }

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
    const Row& row(uint8_t index) const { return core::romRead(rows_)[index]; }
    uint8_t* field(uint8_t index) const;

    const Row* rows_;
    uint8_t count_;
    void* fields_;
};

}  // namespace parameters
