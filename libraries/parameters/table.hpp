// SPDX-License-Identifier: GPL-3.0-or-later
// The shape of a parameter row, the proofs on a table of them and how it is packed into flash. A
// parameter is stored at its slot number, for ever: rows may be sorted or renamed, slots may not.
#pragma once
#include <stddef.h>
#include <stdint.h>

#include "core/packed_text.hpp"
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

constexpr uint8_t widthOf(Type type) {
    return type == Type::int8 ? 1 : type == Type::int16 ? 2 : 4;
}

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

// The numbers of all rows, each once: two hundred rows share a hundred.
template <size_t N>
struct Numbers {
    constexpr explicit Numbers(const Row (&rows)[N]) {
        for (size_t i = 0; i < N; ++i) {
            add(rows[i].initial);
            add(rows[i].lowest);
            add(rows[i].highest);
        }
    }
    // Where it is; `count`: nowhere.
    constexpr size_t find(float value) const {
        size_t at = 0;
        while (at < count && !(values[at] == value)) ++at;
        return at;
    }

    size_t count = 0;
    float values[3 * N] = {};

private:
    constexpr void add(float value) {
        if (find(value) == count) values[count++] = value;
    }
};

// How many there are, to declare the Packed: Packed<core::count(rows), distinctNumbers(rows)>.
template <size_t N>
constexpr size_t distinctNumbers(const Row (&rows)[N]) {
    return Numbers<N>(rows).count;
}

// The codes of all names with their ends together, to declare the Packed.
template <size_t N, size_t kPairs>
constexpr size_t nameCodes(const Row (&rows)[N], const core::CodePair (&pairs)[kPairs]) {
    const core::PairIndex<kPairs> index(pairs);
    size_t codes = 0;
    for (size_t i = 0; i < N; ++i) codes += core::Packing<kNameSize>(rows[i].name, index).size + 1;
    return codes;
}

// A row as it lies in flash.
struct PackedRow {
    uint8_t slot;
    uint8_t initial, lowest, highest;  // places among the numbers
    uint16_t type_and_offset;          // the upper four bits and the lower twelve
    uint16_t name;                     // where it begins among the codes
};
constexpr uint8_t kOffsetBits = 12;

// In flash, ROM: rows of 8 bytes instead of 33, their numbers, and their names, packed.
template <size_t kRows, size_t kNumbers, size_t kCodes, size_t kPairs>
struct Packed {
    constexpr Packed(const Row (&from)[kRows], const core::CodePair (&pairs)[kPairs]) {
        const Numbers<kRows> all(from);
        const core::PairIndex<kPairs> index(pairs);
        for (size_t i = 0; i < kNumbers; ++i) number[i] = all.values[i];
        for (size_t i = 0; i < kPairs; ++i) pair[i] = pairs[i];
        size_t at = 0;
        for (size_t i = 0; i < kRows; ++i) {
            const core::Packing<kNameSize> packed(from[i].name, index);
            row[i].name = static_cast<uint16_t>(at);
            for (size_t j = 0; j < packed.size; ++j) name[at++] = packed.codes[j];
            ++at;  // a zero
            row[i].slot = from[i].slot;
            row[i].initial = static_cast<uint8_t>(all.find(from[i].initial));
            row[i].lowest = static_cast<uint8_t>(all.find(from[i].lowest));
            row[i].highest = static_cast<uint8_t>(all.find(from[i].highest));
            row[i].type_and_offset = static_cast<uint16_t>(
                (static_cast<unsigned>(from[i].type) << kOffsetBits) | from[i].offset);
        }
    }

    PackedRow row[kRows] = {};
    float number[kNumbers] = {};
    uint8_t name[kCodes] = {};
    core::CodePair pair[kPairs] = {};
};

// A table of rows over one struct of fields. Rows and table lie in flash: ROM.
class Table {
public:
    template <size_t kRows, size_t kNumbers, size_t kCodes, size_t kPairs>
    constexpr Table(const Packed<kRows, kNumbers, kCodes, kPairs>& packed, void* fields)
        : rows_(packed.row),
          numbers_(packed.number),
          names_(packed.name),
          pairs_(packed.pair),
          count_(static_cast<uint8_t>(kRows)),
          fields_(fields) {
        static_assert(kRows <= 255, "rows are numbered by a byte");
        static_assert(kNumbers <= 256, "a row has a byte for the place of a number");
    }

    uint8_t count() const { return core::romRead(count_); }
    uint8_t slot(uint8_t index) const;
    Type type(uint8_t index) const;
    void name(uint8_t index, char (&to)[kNameSize]) const;  // padded with zeros
    float value(uint8_t index) const;
    // The bytes of the field, as many as its type is wide. Returns their number.
    uint8_t copyValue(uint8_t index, uint8_t* to) const;

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
    float number(const uint8_t& in_flash) const;
    const uint8_t* codes(const PackedRow& row) const;
    uint8_t* field(uint8_t index) const;

    const PackedRow* rows_;
    const float* numbers_;
    const uint8_t* names_;
    const core::CodePair* pairs_;
    uint8_t count_;
    void* fields_;
};

}  // namespace parameters
