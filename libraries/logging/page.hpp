// SPDX-License-Identifier: GPL-3.0-or-later
// A page of the flight log as it lies in the DataFlash: this head, then whole records. The head
// says whose page it is, so that any page can be looked at by itself; its own checksum
// distinguishes a page of the log from a blank or damaged one, the data's a page whose programming
// was cut short.
#pragma once
#include <stdint.h>

#include "core/crc.hpp"

namespace logging {

// Where something stands: in which log, and how many bytes after its beginning.
struct __attribute__((packed)) Key {
    uint16_t log;  // 1 to 65535, then from 1 again
    uint32_t offset;
};

constexpr uint16_t following(uint16_t log) { return log == 0xFFFF ? 1 : log + 1; }

// Of logs in one ring, which has a quarter of 32768 pages at most.
constexpr bool before(const Key& a, const Key& b) {
    return a.log != b.log ? static_cast<int16_t>(a.log - b.log) < 0 : a.offset < b.offset;
}

struct __attribute__((packed)) PageHead {
    Key key;  // of its first record
    uint16_t used;
    uint16_t data_crc;
    uint16_t head_crc;  // over what stands before it
};
static_assert(sizeof(PageHead) == 12, "as it lies in the chip");

constexpr uint16_t kUncheckedHead = sizeof(PageHead) - sizeof(uint16_t);

inline uint16_t crcOf(const PageHead& head) {
    return core::crc16(core::kCrcStart, &head, kUncheckedHead);
}

inline bool isWhole(const PageHead& head, uint16_t page_size) {
    return head.head_crc == crcOf(head) && head.key.log != 0 && head.used > 0 &&
           head.used <= page_size - sizeof(PageHead);
}

}  // namespace logging
