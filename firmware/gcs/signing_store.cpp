// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/signing_store.hpp"

#include <stddef.h>
#include <string.h>

#include "core/crc.hpp"
#include "core/file_state.hpp"
#include "core/rom.hpp"
#include "core/seldom.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/parameters.hpp"
#include "hal/eeprom.hpp"
#include "storage/eeprom_map.hpp"

namespace firmware {
namespace gcs {

using namespace notify;
using core::Status;

namespace {

constexpr uint16_t kKeyAt = storage::kSigning.begin;
constexpr uint16_t kMarkAt = kKeyAt + kKeySize;
// There is a key: as the first boards have it, and with its CRC. One wrong bit does not count.
constexpr uint16_t kUncheckedKey = 0xC35A, kCheckedKey = 0x3CA5;

constexpr uint32_t kAhead = 46;  // half a minute
// 100,000 writes of each place last for 139 days of signed frames heard, and 69 of those sent.
constexpr uint8_t kReceivedPlaces = 4, kSentPlaces = 2;

struct __attribute__((packed)) StoredTime {
    uint32_t upper;
    uint16_t crc;  // of it; a write may be cut short
};
struct __attribute__((packed)) Stored {  // behind the key
    uint16_t mark;
    StoredTime times[kReceivedPlaces];
    uint16_t key_crc;
};
static_assert(kKeySize + sizeof(Stored) <= storage::kSigning.size, "what is stored does not fit");
static_assert(kSentPlaces * sizeof(StoredTime) <= storage::kSentTime.size, "nor the times sent");

constexpr uint16_t kKeyCrcAt = kMarkAt + offsetof(Stored, key_crc);

struct Places {
    uint16_t begin;
    uint8_t count;
};
constexpr Places kPlaces[] ROM = {{kMarkAt + offsetof(Stored, times), kReceivedPlaces},
                                  {storage::kSentTime.begin, kSentPlaces}};

struct Newest {
    uint32_t upper;
    uint8_t place;
};
struct Store {
    Key key;
    bool sent_is_read;  // the times of what was sent; key and the others come after them
    uint8_t step;       // of storing a key
    Newest newest[core::count(kPlaces)];
};
core::FileState<Store> store{};

Newest& newest(Times which) { return store.newest[static_cast<uint8_t>(which)]; }

uint16_t crcOf(const StoredTime& time) {
    return core::crc16(core::kCrcStart, reinterpret_cast<const uint8_t*>(&time.upper),
                       sizeof time.upper);
}

SELDOM Status writeTime(Times which, uint8_t place, uint32_t upper) {
    StoredTime time = {upper, 0};
    time.crc = crcOf(time);
    const uint16_t begin = core::romRead(kPlaces[static_cast<uint8_t>(which)].begin);
    return hal::eepromWrite(static_cast<uint16_t>(begin + place * sizeof time), &time, sizeof time);
}

bool isMark(uint16_t stored, uint16_t mark) {
    const uint16_t wrong = stored ^ mark;
    return (wrong & (wrong - 1)) == 0;
}

// False: one is damaged and may have been newer, so that what was heard since the one before may
// be heard again.
bool takeTimes(Times which, const StoredTime* times, uint8_t count) {
    bool whole = true;
    Newest& found = newest(which);
    for (uint8_t i = 0; i < count; ++i) {
        if (times[i].crc != crcOf(times[i]))
            whole = false;
        else if (times[i].upper >= found.upper)
            found = {times[i].upper, i};
    }
    return whole;
}

// Each read by itself, as writes may begin in between. What is damaged, or of a version that did
// not sign, does not count: the time is then that of what was heard.
bool readSent() {
    StoredTime sent[kSentPlaces];
    if (store.sent_is_read) return true;
    if (hal::eepromRead(storage::kSentTime.begin, sent, sizeof sent) != Status::ok) return false;
    newest(Times::sent).upper = 0;
    takeTimes(Times::sent, sent, kSentPlaces);
    store.sent_is_read = true;
    return true;
}

void readAgain() {
    store.key = Key::unknown;
    store.sent_is_read = false;
}

// By a key that has changed every signed frame is refused.
SELDOM void readStored() {
    struct __attribute__((packed)) {
        uint8_t key[kKeySize];
        Stored rest;
    } stored;
    if (!readSent()) return;
    if (hal::eepromRead(kKeyAt, &stored, sizeof stored) != Status::ok) return;
    newest(Times::received).upper = 0;
    bool whole = takeTimes(Times::received, stored.rest.times, kReceivedPlaces);
    store.key = Key::set;
    if (isMark(stored.rest.mark, kCheckedKey))
        whole &= stored.rest.key_crc == core::crc16(core::kCrcStart, stored.key, kKeySize);
    else if (!isMark(stored.rest.mark, kUncheckedKey))
        store.key = Key::none;
    if (!whole && store.key == Key::set)
        sendStatusText(Severity::error, STATUS_TEXT("Signing key or time damaged"));
}

constexpr uint8_t kPart = 8, kKeySteps = kKeySize / kPart;  // in small parts, as others write too
constexpr uint8_t kSteps = kKeySteps + kReceivedPlaces + 3;

Status storeStep(uint8_t step, const mavlink::SetupSigning& setup) {
    const uint16_t mark = step == 0 || isZeroKey(setup.secret_key) ? 0 : kCheckedKey;
    if (step == 0 || step == kSteps - 1) return hal::eepromWrite(kMarkAt, &mark, sizeof mark);
    if (step == kSteps - 2) {
        const uint16_t crc = core::crc16(core::kCrcStart, setup.secret_key, kKeySize);
        return hal::eepromWrite(kKeyCrcAt, &crc, sizeof crc);
    }
    const uint8_t at = static_cast<uint8_t>((step - 1) * kPart);
    if (at < kKeySize)
        return hal::eepromWrite(static_cast<uint16_t>(kKeyAt + at), setup.secret_key + at, kPart);
    uint32_t upper;
    memcpy(&upper, reinterpret_cast<const uint8_t*>(&setup.initial_timestamp) + 2, sizeof upper);
    // what is sent is later than that, and than what was sent with another key
    return writeTime(Times::received, static_cast<uint8_t>(step - 1 - kKeySteps), upper);
}

}  // namespace

void signingStoreStart() {
    readAgain();
    store.step = 0;
    readStored();
}

Key signingKey() {
    if (store.key == Key::unknown) readStored();
    return store.key;
}

bool signsLinks() { return store.key == Key::set && state::parameters.sign_policy != 0; }

Status readSigningKey(uint8_t (&key)[kKeySize]) { return hal::eepromRead(kKeyAt, key, kKeySize); }

uint32_t storedTime(Times which) { return newest(which).upper; }

bool storeAhead(Times which, uint32_t upper) {
    Newest& time = newest(which);
    if (upper <= time.upper) return true;
    const uint8_t next = static_cast<uint8_t>(time.place + 1);
    const uint8_t place =
        next < core::romRead(kPlaces[static_cast<uint8_t>(which)].count) ? next : 0;
    if (writeTime(which, place, upper + kAhead) != Status::ok) return false;
    time = {upper + kAhead, place};
    return true;
}

Status storeSigningKey(const mavlink::SetupSigning& setup) {
    for (; store.step < kSteps; ++store.step) {
        const Status status = storeStep(store.step, setup);
        if (status != Status::ok) return status;
    }
    store.step = 0;
    readAgain();
    return Status::ok;
}

void giveUpSigningKey() { store.step = 0; }

bool isZeroKey(const uint8_t (&key)[kKeySize]) {
    uint8_t all = 0;
    for (const uint8_t byte : key) all |= byte;
    return all == 0;
}

}  // namespace gcs
}  // namespace firmware
