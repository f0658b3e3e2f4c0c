// SPDX-License-Identifier: GPL-3.0-or-later
// ArduPilot's self-describing binary log: a record is A3 95, its type, then packed little-endian
// fields; what they are is said by an FMT record that comes before the first of its type.
//   b B int8 uint8   h H int16 uint16   i I int32 uint32   Q uint64   f float   M uint8, a mode
//   c C int16 uint16, 0.01   e E int32 uint32, 0.01   L int32, 1e-7 degrees   n N Z char[4 16 64]
#pragma once
#include <stddef.h>
#include <stdint.h>

#include "core/rom.hpp"

namespace logging {

constexpr uint8_t kHead1 = 0xA3, kHead2 = 0x95;

struct __attribute__((packed)) RecordHead {
    uint8_t head1, head2, type;
};

// An FMT record after its head, which is also how the table of formats lies in flash.
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

template <size_t N>
constexpr void copyTo(char (&to)[N], const char* from) {
    for (size_t i = 0; i < N && from[i] != 0; ++i) to[i] = from[i];
}

constexpr Format format(uint8_t type, const char* name, const char* fields, const char* labels) {
    Format row = {type, sizeof(RecordHead), {}, {}, {}};
    copyTo(row.name, name);
    copyTo(row.fields, fields);
    copyTo(row.labels, labels);
    for (const char* field = fields; *field != 0; ++field) {
        const uint8_t size = sizeOfField(*field);
        // an unknown letter makes a length that no record has
        row.length = static_cast<uint8_t>(size == 0 ? 255 : row.length + size);
    }
    return row;
}

// As many labels as fields, none of them cut off.
constexpr bool isSound(const char* fields, const char* labels) {
    size_t count = 0, commas = 0, size = 0;
    while (fields[count] != 0) ++count;
    for (; labels[size] != 0; ++size) commas += labels[size] == ',';
    return count <= 16 && size <= 64 && commas + 1 == count;
}

}  // namespace logging
