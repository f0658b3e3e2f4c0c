// SPDX-License-Identifier: GPL-3.0-or-later
// The flight logs in the DataFlash: a ring over all the pages that the log has, written page after
// page, so that every page wears alike; when it is full the oldest log gives way. Nothing here
// waits: what answers busy is asked again. Records are put straight into the chip's own buffer and
// stay in one page, so a loss of power costs the page that was being filled and no more.
#pragma once
#include <stdint.h>

#include "core/status.hpp"
#include "logging/page.hpp"

namespace logging {

class LogStore {
public:
    // `base`: the page at which the ring begins, a nextBase(); what cannot be one is taken for 0.
    void start(uint16_t base);

    // Before it is ready: looks at one more page head, or waits for the chip. True: did something.
    // A full chip takes 14 looks and the check of one page.
    bool find();
    bool ready() const { return state_ >= State::ready; }
    bool usable() const { return state_ != State::none; }  // false: no chip that works

    // A new log. busy: not ready, or the chip is erasing still.
    MUST_USE core::Status begin();
    // One record, whole. busy: not now, nothing was taken. unsupported: no log has begun, or the
    // chip has gone.
    MUST_USE core::Status put(const void* record, uint8_t size);
    // Stores the page begun. ok: the log has ended.
    MUST_USE core::Status end();
    bool writing() const { return state_ == State::writing; }
    // Number of the newest log of which a page is in the chip; 0: none.
    uint16_t last() const { return last_; }

    // Erases everything, from the end of the ring down, a block each step. Stopped by begin(): the
    // logs in the blocks not yet reached are still there. False: a log is written, or no chip.
    bool erase();
    bool erasing() const { return state_ == State::erasing; }
    bool eraseStep();  // true: nothing is left; finishErase
    // Where the ring begins from then on: always at the same page, the first ones would wear most.
    uint16_t nextBase() const;
    void finishErase();

    // ---- reading; pages are counted from the oldest
    uint16_t pages() const { return wrapped_ ? ring() - 1 : next_; }
    // corrupt: not a page of a log.
    MUST_USE core::Status readHead(uint16_t page, PageHead& head) const;
    MUST_USE core::Status read(uint16_t page, uint16_t at, void* to, uint8_t size) const;

    // The page at `key` or last before it, one look each call: begin with {0, pages()}; while the
    // answer is busy, again. ok: it is found.first.
    struct Search {
        uint16_t first, end;
    };
    MUST_USE core::Status seek(const Key& key, Search& found) const;

private:
    enum class State : uint8_t {
        none,
        asking,
        ends,
        seeking,
        checking,
        numbering,
        ready,
        writing,
        erasing
    };

    uint16_t ring() const;
    uint16_t place(uint16_t index) const;
    uint16_t fromOldest(uint16_t page) const;
    uint16_t roundRing(uint16_t index) const { return index >= ring() ? index - ring() : index; }
    core::Status headAt(uint16_t index, PageHead& head) const;
    core::Status narrow(uint16_t from, const Key& key, bool upward, Search& search) const;
    core::Status findEnds();
    core::Status check();
    core::Status number();
    core::Status storePage();

    Key key_;  // of the page being filled; while the end is sought, of the ring's first
    uint16_t last_;
    uint16_t next_;  // index of the page to be written next
    uint16_t base_;
    union {
        Search search_;
        struct {
            uint16_t bytes, crc;
        } checked_;
        struct {
            uint16_t used, crc;
        } filling_;
        uint16_t erased_;  // from this index on nothing is left
    };
    State state_;
    bool wrapped_;  // the ring has been full: behind the newest page stands the oldest
};

}  // namespace logging
