// SPDX-License-Identifier: GPL-3.0-or-later
// ArduPilot's self-describing binary log: a record is A3 95, its type, then packed little-endian
// fields; what they are is said by an FMT record that comes before the first of its type.
//   b B int8 uint8   h H int16 uint16   i I int32 uint32   Q uint64   f float   M uint8, a mode
//   c C int16 uint16, 0.01   e E int32 uint32, 0.01   L int32, 1e-7 degrees   n N Z char[4 16 64]
//   d double of 64 bits
// UNIT and MULT records name units and multipliers by letters, FMTU records give them to the
// fields.
#pragma once
#include <stddef.h>
#include <stdint.h>

#include "core/rom.hpp"

namespace logging {

constexpr uint8_t kHead1 = 0xA3, kHead2 = 0x95;

struct __attribute__((packed)) RecordHead {
    uint8_t head1, head2, type;
};

// An FMT record after its head.
struct __attribute__((packed)) Format {
    uint8_t type, length;
    char name[4], fields[16], labels[64];  // padded with zeros, full without
};

struct __attribute__((packed)) FormatRecord {
    RecordHead head;
    Format format;
};
constexpr uint8_t kFormatType = 128;
static_assert(sizeof(FormatRecord) == 89, "FMT");

constexpr uint8_t sizeOfField(char field) {
    switch (field) {
        case 'b':
        case 'B':
        case 'M':
            return 1;
        case 'c':
        case 'C':
        case 'h':
        case 'H':
            return 2;
        case 'e':
        case 'E':
        case 'f':
        case 'i':
        case 'I':
        case 'L':
        case 'n':
            return 4;
        case 'd':
        case 'Q':
            return 8;
        case 'N':
            return 16;
        case 'Z':
            return 64;
        default:
            return 0;
    }
}

// What a format is spelt as: name, fields, units, multipliers and labels, a blank between them.
enum Word : uint8_t { kName, kFields, kUnits, kMultipliers, kLabels, kWords };

struct Letters {
    const char* from;
    uint8_t count;
};

constexpr Letters wordOf(const char* text, Word word) {
    for (uint8_t i = 0; i < word; ++i) {
        while (*text != ' ' && *text != 0) ++text;
        if (*text == ' ') ++text;
    }
    uint8_t count = 0;
    while (text[count] != ' ' && text[count] != 0) ++count;
    return {text, count};
}

// Of the whole record; 0: there is a letter that stands for no field.
constexpr uint8_t lengthOf(const char* text) {
    const Letters fields = wordOf(text, kFields);
    uint8_t length = sizeof(RecordHead);
    for (uint8_t i = 0; i < fields.count; ++i) {
        const uint8_t size = sizeOfField(fields.from[i]);
        if (size == 0) return 0;
        length = static_cast<uint8_t>(length + size);
    }
    return length;
}

// A unit, a multiplier and a label for each field, and nothing that is cut off.
constexpr bool isSound(const char* text) {
    const Letters labels = wordOf(text, kLabels);
    const uint8_t fields = wordOf(text, kFields).count;
    uint8_t commas = 0;
    for (uint8_t i = 0; i < labels.count; ++i) commas += labels.from[i] == ',';
    return wordOf(text, kName).count <= 4 && fields <= 16 && labels.count <= 64 &&
           wordOf(text, kUnits).count == fields && wordOf(text, kMultipliers).count == fields &&
           commas + 1 == fields;
}

}  // namespace logging
