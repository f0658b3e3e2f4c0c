// SPDX-License-Identifier: GPL-3.0-or-later
// docs/mission.md, "Images of ArduPlane 2.x", has the layout.
#include "toolchain/mission_tool/arduplane.hpp"

#include "storage/bytes.hpp"
#include "toolchain/mission_tool/wrong_input.hpp"

namespace mission_tool {
namespace {

using mission::Record;
using storage::get32;
using storage::put32;

constexpr size_t kRecordSize = 15, kFirst = 0x500, kFence = 4096 - 20 * 8;
constexpr size_t kMax = (kFence - kFirst) / kRecordSize;
constexpr uint8_t kNeverWritten = 0xFF, kNothing = 0, kRepeatServo = 0xB8;
constexpr uint32_t kVersionOf3 = 0x65AE;  // stands before the first item from 3.0 on

Record unpack15(const uint8_t* from) {
    Record record = {from[0],
                     from[1],
                     from[2],
                     static_cast<int32_t>(get32(from + 3)),
                     static_cast<int32_t>(get32(from + 7)),
                     static_cast<int32_t>(get32(from + 11))};
    // there it is servo, pulse, repeats, time; here servo, repeats, time, pulse
    if (record.id == kRepeatServo) {
        const int32_t pulse_us = record.p2;
        record.p2 = record.p3;
        record.p3 = record.p4;
        record.p4 = pulse_us;
    }
    return record;
}

void pack15(Record record, uint8_t* to) {
    if (record.id == kRepeatServo) {
        const int32_t pulse_us = record.p4;
        record.p4 = record.p3;
        record.p3 = record.p2;
        record.p2 = pulse_us;
    }
    to[0] = record.id;
    to[1] = record.options;
    to[2] = record.p1;
    put32(to + 3, static_cast<uint32_t>(record.p2));
    put32(to + 7, static_cast<uint32_t>(record.p3));
    put32(to + 11, static_cast<uint32_t>(record.p4));
}

}  // namespace

std::string arduPlaneIn(const Image& image) {
    if (image[0] != 'P' || image[1] != 'A') return "";  // the mark of its parameters
    if (get32(image.data() + kFirst) == kVersionOf3) {
        return "ArduPlane's EEPROM, 3.0 or later: --records 15 reads its mission";
    }
    return "ArduPlane's EEPROM: --records 15 reads the mission of a 2.x board";
}

Document readRecords15(const Image& image, const std::string& name, size_t count) {
    if (count > kMax) {
        throw WrongInput(name + ": --count: expected at most " + std::to_string(kMax));
    }
    if (get32(image.data() + kFirst) == kVersionOf3) return readMissionOf3(image, name, count);
    Document document;
    document.name = name;
    for (size_t index = 0; index < (count != 0 ? count : kMax); ++index) {
        const uint8_t* from = image.data() + kFirst + index * kRecordSize;
        const bool written = from[0] != kNeverWritten && from[0] != kNothing;
        if (count == 0 && !written) break;
        Entry entry;
        entry.record = unpack15(from);
        if (!mission::fits(document.set, entry.record)) {
            throw WrongInput(name + ": item " + std::to_string(index) +
                             ": expected a second parameter of at most 24 bits, found " +
                             std::to_string(entry.record.p2));
        }
        document.entries.push_back(entry);
    }
    if (document.entries.empty()) throw WrongInput(name + ": no mission of 15-byte records in it");
    return document;
}

Image writeRecords15(const Document& document, const Image& onto) {
    if (document.set != mission::Set::apm2) {
        throw WrongInput(document.name + ": 15-byte records hold the APM 2.0 set only");
    }
    if (get32(onto.data() + kFirst) == kVersionOf3) {
        throw WrongInput("a board of ArduPlane 3.0 or later: only a ground station writes to it");
    }
    if (document.entries.size() > kMax) {
        throw WrongInput(document.name + ": expected at most " + std::to_string(kMax) + " items");
    }
    Image image = onto;
    for (size_t index = 0; index < document.entries.size(); ++index) {
        pack15(document.entries[index].record, image.data() + kFirst + index * kRecordSize);
    }
    // the end for a reader that does not know CMD_TOTAL
    if (document.entries.size() < kMax) {
        image[kFirst + document.entries.size() * kRecordSize] = kNeverWritten;
    }
    return image;
}

}  // namespace mission_tool
