// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of fixed-size records, each of which changes as a whole: a power cut at any moment leaves
// the old or the new one. A new list is staged where the present one is not (in the DataFlash, or
// without one in the free part of the EEPROM's ring), read back, and made the present one by a
// single small write, its head. Then the other head is made to name the same list, so that one of
// them may be damaged: never does an older list come back. What is in the DataFlash is copied to
// the EEPROM when there is time, and has another head after that. Knows nothing of what is in the
// records.
#pragma once
#include <stdint.h>

#include "core/status.hpp"
#include "storage/lists.hpp"

namespace storage {

class ListStore {
public:
    // At start, until it is ok: finds and checks the lists, a part each call. corrupt: something
    // was stored as `which` and is not whole; unsupported: it is in a DataFlash that does not
    // answer. That list is then empty until one is committed.
    MUST_USE core::Status open(ListKind& which);

    uint8_t count(ListKind kind) const { return of(kind).count; }
    uint8_t set(ListKind kind) const { return of(kind).set; }
    uint8_t generation(ListKind kind) const { return of(kind).generation; }  // differs after commit
    uint32_t id(ListKind kind) const { return listId(of(kind).set, of(kind).count, of(kind).crc); }

    // busy: in a later frame. bad_argument: no such record.
    MUST_USE core::Status read(ListKind kind, uint8_t index, uint8_t* to) {
        return readRecord(kind, of(kind), index, to);
    }

    // A new list, once hal::flashKnown(); what was staged before is forgotten. full: no room beside
    // the present one. busy: a commit is not yet done.
    MUST_USE core::Status begin(ListKind kind, uint8_t count, uint8_t set);
    MUST_USE core::Status put(const uint8_t* record);  // in order; busy: again later
    MUST_USE core::Status copy();                      // puts the present list's record
    uint8_t staged() const { return put_; }
    uint8_t stagedCount() const { return other_.count; }
    uint8_t stagedSet() const { return other_.set; }
    ListKind kind() const { return kind_; }  // of what is staged, or was committed last
    bool staging(ListKind kind) const { return phase_ == Phase::filling && kind_ == kind; }
    // Until it is not busy. ok: the new list is the list and would survive a power cut; its heads
    // have been read back. corrupt: what was read back is not what was put; the old list stays.
    MUST_USE core::Status commit();
    void abort();  // without effect once the head is being written

    // The list before the last commit, until the next begin() or migrateToEeprom().
    uint8_t previousCount() const { return other_.count; }
    uint8_t previousSet() const { return other_.set; }
    MUST_USE core::Status readPrevious(uint8_t index, uint8_t* to) {
        return readRecord(kind_, other_, index, to);
    }

    // Carries the copying on, and writes the head that a list is short of. ok: nothing is to be
    // done. corrupt, once: the EEPROM does not keep what is written; the list stays in the
    // DataFlash, or has one head only.
    MUST_USE core::Status migrateToEeprom();
    // Once that is ok: a list of which open() had found a head or the records damaged, and which
    // has both again. False: there is none, or no other one.
    bool takeMended(ListKind& which);

    // Also then, again and again: whether the mission's records still are what was committed. ok:
    // they are, all of them. corrupt: they are not, and the mission is empty now; the next start
    // looks for the other copy.
    MUST_USE core::Status recheck();

    // Whether new lists are staged in the DataFlash.
    bool flashWorks() const;

private:
    enum class Phase : uint8_t {
        finding,
        checking,  // open()
        idle,
        copying,
        summing_copy,
        copied,
        migrating,  // migrateToEeprom()
        filling,
        storing,
        verifying,
        heading,
        headed,
        heading_twice  // a new list
    };

    const Extent& of(ListKind kind) const { return present_[static_cast<uint8_t>(kind)]; }
    // Not inlined: the product for its address stands in a dozen places.
    __attribute__((noinline)) Extent& present() { return present_[static_cast<uint8_t>(kind_)]; }
    bool inFlash() const { return other_.place != Place::eeprom; }

    core::Status find();
    void sumFromStart();
    core::Status sum(const Extent& extent, uint8_t end, uint8_t most);
    core::Status sumMatches(const Extent& extent);
    core::Status place(Extent& staged, const Extent& now, uint8_t slots) const;
    core::Status storePages();
    core::Status failed(core::Status status);
    core::Status makeDurable();
    bool findUnmigrated();
    uint8_t bit() const { return static_cast<uint8_t>(1 << static_cast<uint8_t>(kind_)); }
    void setLone(bool lone) { lone_ = static_cast<uint8_t>(lone ? lone_ | bit() : lone_ & ~bit()); }
    core::Status copyRecords();
    core::Status head(const Extent& target, Phase writing);

    Extent present_[kListKinds] = {};
    Extent other_ = {};  // while opening a candidate, then the staged list, then the previous one
    uint16_t crc_ = 0;   // of the records summed so far
    uint8_t summed_ = 0;
    uint8_t put_ = 0;                    // records staged, or copied
    uint8_t stored_ = 0;                 // pages handed to the DataFlash
    ListKind kind_ = ListKind::mission;  // being worked on
    Phase phase_ = Phase::finding;
    uint8_t lone_ = 0;        // lists, a bit each, that only one head names
    uint8_t mended_ = 0;      // that were damaged
    bool rechecks_ = false;   // what is summed is for recheck()
    bool last_head_ = false;  // no other one is left to try
    bool flash_bad_ = false;  // it has not kept what was written
    bool eeprom_bad_ = false;
};

}  // namespace storage
