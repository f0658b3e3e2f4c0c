// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/owner.hpp"

#include <string.h>

#include "core/crc.hpp"
#include "core/rom.hpp"
#include "storage/bytes.hpp"
#include "storage/eeprom_map.hpp"

namespace storage {
namespace {

using core::Status;

// The mark, the layout version, the CRC of these five bytes, a blank: twice.
constexpr uint8_t kMark[] ROM = {0xB7, 'A', 'P', 'M'};
constexpr uint8_t kTraceSize = sizeof kMark;
constexpr uint8_t kOurSize = 8, kTwice = 2 * kOurSize;
static_assert(kTwice == kHeader.size, "our marks fill the header");

void ours(uint8_t (&header)[kTwice], uint8_t version) {
    for (uint8_t i = 0; i < kTraceSize; ++i) header[i] = core::romRead(kMark[i]);
    header[kTraceSize] = version;
    put16(header + kTraceSize + 1, core::crc16(core::kCrcStart, header, kTraceSize + 1));
    header[kOurSize - 1] = 0xFF;
    memcpy(header + kOurSize, header, kOurSize);
}

bool blank(const uint8_t* bytes, uint8_t size) {
    while (size-- > 0)
        if (*bytes++ != 0xFF) return false;
    return true;
}

// The first bytes of our marks and then nothing: the power went while they were being written.
bool begun(const uint8_t (&header)[kTwice], const uint8_t (&wanted)[kTwice]) {
    uint8_t same = 0;
    while (same < kTwice && header[same] == wanted[same]) ++same;
    return blank(header + same, static_cast<uint8_t>(kTwice - same));
}

// One of the two is whole, of the version it has.
bool marked(const uint8_t* mark, uint8_t& version) {
    uint8_t wanted[kTwice];
    version = mark[kTraceSize];
    ours(wanted, version);
    return memcmp(mark, wanted, kOurSize - 1) == 0;
}

Status restIsBlank(bool& is) {
    is = true;
    constexpr uint8_t kPart = 32;
    for (uint16_t at = kHeader.end(); is && at < hal::kEepromSize; at += kPart) {
        uint8_t bytes[kPart];
        const uint16_t left = hal::kEepromSize - at;
        const uint8_t size = left < kPart ? static_cast<uint8_t>(left) : kPart;
        const Status status = hal::eepromRead(at, bytes, size);
        if (status != Status::ok) return status;
        is = blank(bytes, size);
    }
    return Status::ok;
}

}  // namespace

Status findOwner(Owner& owner) {
    uint8_t header[kTwice];
    const Status status = hal::eepromRead(kHeader.begin, header, sizeof header);
    if (status != Status::ok) return status;
    uint8_t version;
    if (marked(header, version) || marked(header + kOurSize, version)) {
        owner = version == kLayoutVersion ? Owner::ours : Owner::other_version;
        return Status::ok;
    }
    uint8_t wanted[kTwice];
    ours(wanted, kLayoutVersion);
    bool unused = false;
    if (begun(header, wanted)) {
        const Status scanned = restIsBlank(unused);
        if (scanned != Status::ok) return scanned;
    }
    owner = unused ? Owner::blank : Owner::foreign;
    return Status::ok;
}

Status claim() {
    uint8_t header[kTwice];
    ours(header, kLayoutVersion);
    return hal::eepromWrite(kHeader.begin, header, sizeof header);
}

Status mendMarks(bool& damaged) {
    uint8_t header[kTwice], wanted[kTwice];
    damaged = false;
    const Status status = hal::eepromRead(kHeader.begin, header, sizeof header);
    if (status != Status::ok) return status;
    ours(wanted, kLayoutVersion);
    damaged = !begun(header, wanted);
    return claim();
}

Status writeIfOurs(uint16_t address, const void* from, uint8_t size) {
    Owner owner;
    const Status status = findOwner(owner);
    if (status != Status::ok || owner != Owner::ours) return status;
    return hal::eepromWrite(address, from, size);
}

Status erase(uint16_t& at) {
    uint8_t nothing[16];
    memset(nothing, 0xFF, sizeof nothing);
    while (at < hal::kEepromSize) {
        const Status status = hal::eepromWrite(at, nothing, sizeof nothing);
        if (status != Status::ok) return status;
        at = static_cast<uint16_t>(at + sizeof nothing);
    }
    const Status status = claim();
    if (status != Status::ok) return status;
    return hal::eepromDrained() ? Status::ok : Status::busy;
}

}  // namespace storage
