// SPDX-License-Identifier: GPL-3.0-or-later
// One log as the bytes that are handed out: its records one behind the other, without the heads of
// the chip's pages. Of a log whose beginning the ring has overwritten the formats are put in front
// again, so that what is left can be read. Takes a look or two each call, like the store.
#pragma once
#include <stdint.h>

#include "logging/format.hpp"
#include "logging/log_store.hpp"

namespace logging {

struct Formats {
    void (*spell)(uint8_t index, Format& to);
    uint8_t count;
};

// The page that can be read of the oldest ones. corrupt: none.
MUST_USE core::Status oldestKey(const LogStore& store, Key& key);

class Reader {
public:
    void open(const LogStore& store, uint16_t log) {
        log_ = log;
        found_ = {0, store.pages()};
    }
    uint16_t log() const { return log_; }

    // busy: again. corrupt: there is no such log.
    MUST_USE core::Status size(const LogStore& store, const Formats& formats, uint32_t& bytes);

    // At least one byte from `at` on, at most `size`, which becomes how many. The log must have so
    // many. A page that cannot be read any more is read as zeros.
    MUST_USE core::Status read(const LogStore& store, const Formats& formats, uint32_t at,
                               uint8_t* to, uint8_t& size);

private:
    core::Status missing(const LogStore& store, uint32_t& bytes) const;
    core::Status findPage(const LogStore& store, uint32_t offset, PageHead& head);

    uint16_t log_;
    LogStore::Search found_;
};

}  // namespace logging
