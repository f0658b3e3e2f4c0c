// SPDX-License-Identifier: GPL-3.0-or-later
// All parameters of a table as one file, in the format that ArduPilot serves as @PARAM/param.pck
// (described in AP_Filesystem_Param.h and read by MAVProxy, Mission Planner and QGroundControl). A
// header of three numbers, then one entry a parameter, which leaves out the letters that its name
// has in common with the one before. Values change, the places of the bytes do not.
#pragma once
#include "core/status.hpp"
#include "parameters/table.hpp"

namespace parameters {

// uint16_t each, little-endian: the magic number, the parameters in the file, all there are.
constexpr uint16_t kFileMagic = 0x671B;
constexpr uint8_t kFileHeader = 6;

// An entry: the type, 1 to 4 for int8 to float; the letters in common, with the number of the
// others less one in the upper four bits; these letters; the value.
constexpr uint8_t kEntryHead = 2;
constexpr uint8_t kLongestEntry = kEntryHead + kNameSize + 4;

// How many letters at the beginning are left out: never the last one. Both end at a zero or at
// kNameSize letters.
constexpr uint8_t commonLetters(const char* name, const char* before) {
    uint8_t common = 0;
    while (common + 1 < kNameSize && name[common + 1] != 0 && name[common] == before[common])
        ++common;
    return common;
}
constexpr uint8_t lengthOf(const char* name) {
    uint8_t length = 0;
    while (length < kNameSize && name[length] != 0) ++length;
    return length;
}

// Bytes of the file.
template <size_t N>
constexpr uint16_t fileSize(const Row (&rows)[N]) {
    uint16_t size = kFileHeader;
    const char* before = "";
    for (size_t i = 0; i < N; ++i) {
        const char* name = rows[i].name;
        size = static_cast<uint16_t>(size + kEntryHead + lengthOf(name) -
                                     commonLetters(name, before) + widthOf(rows[i].type));
        before = name;
    }
    return size;
}

// Where one read ended, so that the next does not count from the beginning.
struct FileCursor {
    uint16_t at = 0;     // the file's byte with which this part begins:
    uint8_t number = 0;  // 0 the header, n the entry of row n - 1
};

// Copies up to `size` bytes of the file from `offset` on; `size` becomes how many, fewer only where
// the file ends. busy: the offset is further away than one call goes; call again.
core::Status readFile(const Table& table, FileCursor& cursor, uint16_t offset, uint8_t* to,
                      uint8_t& size);

}  // namespace parameters
