// SPDX-License-Identifier: GPL-3.0-or-later
// A table of rows as it lies in flash, half its size as written: the numbers of all rows stand once
// each in a pool, the names one behind the other, the last letter of each marked.
//   constexpr Row kRows[] = {...};                        // for the compiler
//   constexpr auto kPacked ROM = PACK_PARAMETERS(kRows);  // for the chip
#pragma once
#include "parameters/table.hpp"

namespace parameters {

constexpr uint8_t kTypeShift = 12;
constexpr uint16_t kOffsetMask = (1u << kTypeShift) - 1;
constexpr uint8_t kLastLetter = 0x80;
constexpr uint8_t kGroup = 16;  // rows: where the name of the first begins is kept

constexpr size_t groupsOf(size_t rows) { return (rows + kGroup - 1) / kGroup; }

template <size_t rows, size_t numbers, size_t letters>
struct Packed {
    float number[numbers];
    PackedRow row[rows];
    uint16_t group[groupsOf(rows)];
    uint8_t letter[letters];
};

constexpr size_t lengthOf(const char* text) {
    size_t length = 0;
    while (text[length] != 0) ++length;
    return length;
}

template <size_t N>
constexpr size_t lettersOf(const Row (&rows)[N]) {
    size_t letters = 0;
    for (size_t i = 0; i < N; ++i) letters += lengthOf(rows[i].name);
    return letters;
}

constexpr float numberOf(const Row& row, size_t which) {
    return which == 0 ? row.initial : (which == 1 ? row.lowest : row.highest);
}

// The pool's place of the number, which is added when it is not there yet.
constexpr size_t placeOf(float number, float* pool, size_t& used) {
    size_t place = 0;
    while (place < used && pool[place] != number) ++place;
    if (place == used) pool[used++] = number;
    return place;
}

template <size_t N>
constexpr size_t numbersOf(const Row (&rows)[N]) {
    float pool[3 * N] = {};
    size_t used = 0;
    for (size_t i = 0; i < N; ++i)
        for (size_t which = 0; which < 3; ++which) placeOf(numberOf(rows[i], which), pool, used);
    return used;
}

template <class To, size_t N>
constexpr To packed(const Row (&rows)[N]) {
    To to = {};
    size_t used = 0, letter = 0;
    for (size_t i = 0; i < N; ++i) {
        PackedRow& row = to.row[i];
        row.field = static_cast<uint16_t>((static_cast<uint16_t>(rows[i].type) << kTypeShift) |
                                          rows[i].offset);
        if (i % kGroup == 0) to.group[i / kGroup] = static_cast<uint16_t>(letter);
        row.slot = rows[i].slot;
        row.initial = static_cast<uint8_t>(placeOf(rows[i].initial, to.number, used));
        row.lowest = static_cast<uint8_t>(placeOf(rows[i].lowest, to.number, used));
        row.highest = static_cast<uint8_t>(placeOf(rows[i].highest, to.number, used));
        for (const char* c = rows[i].name; *c != 0; ++c)
            to.letter[letter++] = static_cast<uint8_t>(*c);
        to.letter[letter - 1] |= kLastLetter;
    }
    return to;
}

template <size_t N>
constexpr bool offsetsFit(const Row (&rows)[N]) {
    for (size_t i = 0; i < N; ++i)
        if (rows[i].offset > kOffsetMask || rows[i].name[0] == 0) return false;
    return true;
}

#define PACK_PARAMETERS(rows)                                                                     \
    ::parameters::packed<::parameters::Packed<::core::count(rows), ::parameters::numbersOf(rows), \
                                              ::parameters::lettersOf(rows)>>(rows)

}  // namespace parameters
