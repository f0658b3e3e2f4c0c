// SPDX-License-Identifier: GPL-3.0-or-later
// Every byte of the EEPROM, in address order. A region begins where the one above it ends; the
// last lines prove that the sum fits. Changing a size moves what follows, so it also means a new
// kLayoutVersion and a way to carry the older layout over.
#pragma once
#include <stdint.h>

#include "hal/eeprom.hpp"

namespace storage {

constexpr uint8_t kLayoutVersion = 1;

struct Region {
    uint16_t begin;
    uint16_t size;
    constexpr uint16_t end() const { return static_cast<uint16_t>(begin + size); }
};
constexpr Region after(Region previous, uint16_t size) { return {previous.end(), size}; }
constexpr bool overlap(Region a, Region b) { return a.begin < b.end() && b.begin < a.end(); }

constexpr uint8_t kParameterSize = 4;
constexpr uint16_t kParameterSlots = 256;  // a table's slot numbers are bytes
constexpr uint8_t kJournalEntrySize = 8;
constexpr uint8_t kJournalEntries = 8;
constexpr uint8_t kCheckSize = 4;
constexpr uint8_t kHeadSize = 16;
constexpr uint8_t kRecordSize = 14;
constexpr uint8_t kRecordSlots = 171;  // home and 170 commands
constexpr uint8_t kFenceSize = 10;
constexpr uint8_t kFencePoints = 20;
constexpr uint8_t kRallySize = 11;
constexpr uint8_t kRallyPoints = 10;
constexpr uint8_t kIndexEntrySize = 3;
constexpr uint8_t kIndexEntries = 21;

// clang-format off
constexpr Region kHeader      = {0, 16};                                 // magic, layout version
constexpr Region kParameters  = after(kHeader,      kParameterSlots * kParameterSize);
constexpr Region kSigning     = after(kParameters,  64);                 // key and time of signed links
constexpr Region kJournal     = after(kSigning,     kJournalEntries * kJournalEntrySize);
constexpr Region kMissionHead = after(kJournal,     2 * kHeadSize);
constexpr Region kMission     = after(kMissionHead, kRecordSlots * kRecordSize);
constexpr Region kFence       = after(kMission,     kFencePoints * kFenceSize);
constexpr Region kFenceHead   = after(kFence,       2 * kHeadSize);
constexpr Region kRallyHead   = after(kFenceHead,   2 * kHeadSize);
constexpr Region kChecks      = after(kRallyHead,   2 * kCheckSize);     // of the parameters, twice
constexpr Region kSentTime    = after(kChecks,      12);                 // of signed links
constexpr Region kGap         = after(kSentTime,    4);
constexpr Region kIndex       = after(kGap,         64);                 // the mission's, wear spread
constexpr Region kHomeAndLog  = after(kIndex,       32);
constexpr Region kRally       = after(kHomeAndLog,  kRallyPoints * kRallySize);
constexpr Region kSpare       = after(kRally,       hal::kEepromSize - kRally.end());
// clang-format on

static_assert(kRally.end() <= hal::kEepromSize, "the EEPROM map is larger than the EEPROM");
static_assert(kSpare.end() == hal::kEepromSize, "the EEPROM map must account for every byte");
static_assert(!overlap(kParameters, kMission), "a full mission must not reach the parameters");
static_assert(kIndexEntries * kIndexEntrySize <= kIndex.size, "index entries do not fit");
static_assert(kHeadSize <= hal::kEepromQueue, "a head is queued in one piece");
// Fence, rally points, signing and the parameters' checks came later, into places that were blank.
static_assert(kJournal.begin == 1104 && kMission.begin == 1200 && kIndex.begin == 3882 &&
                  kHomeAndLog.begin == 3946,
              "layout 1 has these where its first boards have them");

constexpr uint16_t parameterAddress(uint16_t slot) {
    return static_cast<uint16_t>(kParameters.begin + slot * kParameterSize);
}
constexpr uint16_t recordAddress(uint8_t slot) {
    return static_cast<uint16_t>(kMission.begin + slot * kRecordSize);
}

}  // namespace storage
