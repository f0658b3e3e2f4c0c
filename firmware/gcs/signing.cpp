// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/signing.hpp"

#include <stddef.h>
#include <string.h>

#include "core/crc.hpp"
#include "core/file_state.hpp"
#include "core/rom.hpp"
#include "core/seldom.hpp"
#include "crypto/sha256.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/vehicle.hpp"
#include "hal/eeprom.hpp"
#include "storage/eeprom_map.hpp"

namespace firmware {
namespace gcs {

using namespace notify;
using namespace state;

namespace {

using core::Status;

constexpr uint8_t kKeySize = 32;
constexpr uint16_t kKeyAt = storage::kSigning.begin;
constexpr uint16_t kMarkAt = kKeyAt + kKeySize;
// There is a key: as the first boards have it, and with its CRC. One wrong bit does not count.
constexpr uint16_t kUncheckedKey = 0xC35A, kCheckedKey = 0x3CA5;

// Of a time in 10 us since 2015 the upper 32 of its 48 bits: 0.655 s each.
constexpr uint32_t kMinute = 91;
// The time is stored that far ahead of what is obeyed. Four places: 100,000 writes of each last for
// 139 days of signed frames.
constexpr uint32_t kAhead = 46;
constexpr uint8_t kTimes = 4;

struct __attribute__((packed)) StoredTime {
    uint32_t upper;
    uint16_t crc;  // of it; a write may be cut short
};
struct __attribute__((packed)) Stored {  // behind the key
    uint16_t mark;
    StoredTime times[kTimes];
    uint16_t key_crc;
};
static_assert(kKeySize + sizeof(Stored) <= storage::kSigning.size, "what is stored does not fit");

constexpr uint16_t kKeyCrcAt = kMarkAt + offsetof(Stored, key_crc);

struct __attribute__((packed)) Signature {
    uint8_t link;
    uint16_t lower;  // of the time
    uint32_t upper;
    uint8_t hash[6];
};
static_assert(sizeof(Signature) == mavlink::kSignature, "as it stands behind a frame");
constexpr uint8_t kHashed = 7;  // of its bytes: link and time

struct Stream {  // what has one count of time: a link of a component
    uint8_t link, system, component;
    uint16_t lower;
    uint32_t upper;  // 0: none
};
constexpr uint8_t kStreams = 2;

enum class Key : uint8_t { unknown, none, set };

struct Signing {
    const Link* checking;  // whose frame; nullptr: none
    Key key;
    uint8_t taken;  // bytes of its signature
    uint8_t block;
    bool filled;   // the block is in the hash, to be worked on
    uint8_t step;  // of storing a key
    uint8_t stored_at;
    Signature signature;
    uint32_t stored;  // what is obeyed is not later than this
    uint32_t floor;   // a stream that is not known begins after this
    Stream streams[kStreams];
    crypto::Sha256 sha;
};
core::FileState<Signing> signing{};

uint16_t crcOf(const StoredTime& time) {
    return core::crc16(core::kCrcStart, reinterpret_cast<const uint8_t*>(&time.upper),
                       sizeof time.upper);
}

uint16_t timeAddress(uint8_t place) {
    return static_cast<uint16_t>(kMarkAt + sizeof(uint16_t) + place * sizeof(StoredTime));
}

SELDOM StoredTime storedTime(uint32_t upper) {
    StoredTime time = {upper, 0};
    time.crc = crcOf(time);
    return time;
}

bool isMark(uint16_t stored, uint16_t mark) {
    const uint16_t wrong = stored ^ mark;
    return (wrong & (wrong - 1)) == 0;
}

// The newest. False: one is damaged and may have been newer, so that what was heard since the one
// before may be heard again.
bool takeTimes(const StoredTime (&times)[kTimes]) {
    bool whole = true;
    signing.stored = 0;
    for (uint8_t i = 0; i < kTimes; ++i) {
        const StoredTime& time = times[i];
        if (time.crc != crcOf(time)) {
            whole = false;
        } else if (time.upper >= signing.stored) {
            signing.stored = time.upper;
            signing.stored_at = i;
        }
    }
    signing.floor = signing.stored;
    return whole;
}

// By a key that has changed every signed frame is refused.
SELDOM void readStored() {
    struct __attribute__((packed)) {
        uint8_t key[kKeySize];
        Stored rest;
    } stored;
    if (hal::eepromRead(kKeyAt, &stored, sizeof stored) != Status::ok) return;
    memset(signing.streams, 0, sizeof signing.streams);
    bool whole = takeTimes(stored.rest.times);
    signing.key = Key::set;
    if (isMark(stored.rest.mark, kCheckedKey))
        whole &= stored.rest.key_crc == core::crc16(core::kCrcStart, stored.key, kKeySize);
    else if (!isMark(stored.rest.mark, kUncheckedKey))
        signing.key = Key::none;
    if (!whole && signing.key == Key::set)
        sendStatusText(Severity::error, STATUS_TEXT("Signing key or time damaged"));
}

// What a link is kept alive by, and what a radio says of itself; and over USB a new key.
bool needsNone(const Link& link, uint16_t id) {
    static constexpr uint16_t kIds[] ROM = {
        mavlink::Wire<mavlink::Heartbeat>::id, mavlink::Wire<mavlink::RadioStatus>::id,
        mavlink::Wire<mavlink::Radio>::id, mavlink::Wire<mavlink::SetupSigning>::id};
    uint8_t count = core::count(kIds);
    if (!isUsb(link)) --count;
    for (uint8_t i = 0; i < count; ++i)
        if (core::romRead(kIds[i]) == id) return true;
    return false;
}

bool mayBeUnsigned(const Link& link, uint16_t id) {
    if (signing.key == Key::none || parameters.sign_policy == 0) return true;
    return (parameters.sign_policy == 1 && isUsb(link)) || needsNone(link, id);
}

bool takeSignature(Link& link) {
    uint8_t* const bytes = reinterpret_cast<uint8_t*>(&signing.signature);
    for (; signing.taken < sizeof(Signature); ++signing.taken) {
        uint8_t& byte = bytes[signing.taken];
        if (!link.parser.takeBehind(byte) && !hal::serialRead(portOf(link), byte)) return false;
    }
    return true;
}

Stream* streamOf(const mavlink::Frame& frame) {
    for (Stream& stream : signing.streams)
        if (stream.upper != 0 && stream.link == signing.signature.link &&
            stream.system == frame.system && stream.component == frame.component)
            return &stream;
    return nullptr;
}

bool isLater(const mavlink::Frame& frame) {
    const Signature& now = signing.signature;
    const Stream* const stream = streamOf(frame);
    if (stream != nullptr)
        return now.upper > stream->upper ||
               (now.upper == stream->upper && now.lower > stream->lower);
    if (now.upper <= signing.floor) return false;
    for (const Stream& other : signing.streams)
        if (other.upper > now.upper && other.upper - now.upper > kMinute) return false;
    return true;
}

// A stream that has to give way: what was heard of it is not heard again, under any name.
Stream& place() {
    Stream* oldest = signing.streams;
    for (Stream& stream : signing.streams)
        if (stream.upper < oldest->upper) oldest = &stream;
    if (oldest->upper > signing.floor) signing.floor = oldest->upper;
    return *oldest;
}

bool storeAhead() {
    if (signing.signature.upper <= signing.stored) return true;
    const StoredTime time = storedTime(signing.signature.upper + kAhead);
    const uint8_t at = (signing.stored_at + 1) % kTimes;
    if (hal::eepromWrite(timeAddress(at), &time, sizeof time) != Status::ok) return false;
    signing.stored_at = at;
    signing.stored = time.upper;
    return true;
}

void record(const mavlink::Frame& frame) {
    Stream* const known = streamOf(frame);
    Stream& stream = known != nullptr ? *known : place();
    stream = {signing.signature.link, frame.system, frame.component, signing.signature.lower,
              signing.signature.upper};
}

uint8_t sizeOf(const mavlink::Frame& frame) {
    return static_cast<uint8_t>(mavlink::kHeaderV2 + frame.length + mavlink::kChecksum);
}

// The hash is of key, frame, and link and time of the signature. False: the EEPROM is busy.
SELDOM bool fill(const mavlink::Frame& frame) {
    crypto::Sha256& sha = signing.sha;
    uint8_t at = 0;
    if (signing.block == 0) {
        uint8_t key[kKeySize];
        if (hal::eepromRead(kKeyAt, key, sizeof key) != Status::ok) return false;
        sha.begin();
        for (; at < kKeySize; ++at) sha.byte(at) = key[at];
    }
    const uint8_t* const bytes = frame.payload - mavlink::kHeaderV2;
    const uint8_t* const signature = reinterpret_cast<const uint8_t*>(&signing.signature);
    const uint8_t size = sizeOf(frame);
    uint8_t from = static_cast<uint8_t>(signing.block * crypto::kBlockSize + at - kKeySize);
    for (; at < crypto::kBlockSize; ++at, ++from) {
        if (from < size)
            sha.byte(at) = bytes[from];
        else if (from - size < kHashed)
            sha.byte(at) = signature[from - size];
    }
    sha.pad(signing.block, kKeySize + size + kHashed);
    return true;
}

// One slice; works: the hash is not done.
Verdict hashOn(const mavlink::Frame& frame) {
    if (!signing.filled) {
        signing.filled = fill(frame);
        return signing.filled ? Verdict::works : Verdict::waits;
    }
    if (signing.sha.quarter()) {
        signing.filled = false;
        ++signing.block;
    }
    return Verdict::works;
}

bool hashFits() {
    uint8_t differs = 0;  // looked at whole: the time it takes says nothing
    for (uint8_t i = 0; i < sizeof signing.signature.hash; ++i)
        differs |= static_cast<uint8_t>(signing.sha.hash(i) ^ signing.signature.hash[i]);
    return differs == 0;
}

Verdict check(Link& link, const mavlink::Frame& frame) {
    if (signing.checking == nullptr) {
        signing.checking = &link;
        signing.taken = signing.block = 0;
        signing.filled = false;
    }
    if (signing.checking != &link || !takeSignature(link)) return Verdict::waits;
    if (!isLater(frame)) return Verdict::refused;
    if (signing.block < crypto::blocksOf(kKeySize + sizeOf(frame) + kHashed)) return hashOn(frame);
    if (!hashFits()) return Verdict::refused;
    if (!storeAhead()) return Verdict::waits;
    record(frame);
    return Verdict::obeyed;
}

bool isZero(const uint8_t* key) {
    uint8_t all = 0;
    for (uint8_t i = 0; i < kKeySize; ++i) all |= key[i];
    return all == 0;
}

// Without its mark there is no key: a power cut leaves none. In small parts, as others write too.
constexpr uint8_t kPart = 8, kKeySteps = kKeySize / kPart;
constexpr uint8_t kSteps = kKeySteps + kTimes + 3;

Status storeStep(uint8_t step, const mavlink::SetupSigning& setup, bool clears) {
    const uint16_t mark = step == 0 || clears ? 0 : kCheckedKey;
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
    const StoredTime time = storedTime(upper);
    return hal::eepromWrite(timeAddress(static_cast<uint8_t>(step - 1 - kKeySteps)), &time,
                            sizeof time);
}

}  // namespace

void signingStart() {
    signing.key = Key::unknown;
    signing.checking = nullptr;
    signing.step = 0;
    readStored();
}

SELDOM Verdict signingVerdict(Link& link, const mavlink::Frame& frame) {
    if (signing.key == Key::unknown) readStored();
    if (signing.key == Key::unknown) return Verdict::waits;
    if (mayBeUnsigned(link, frame.id)) return Verdict::obeyed;
    if (!link.parser.isSigned()) return Verdict::refused;
    return check(link, frame);
}

void signingForget(Link& link) {
    if (signing.checking != &link) return;
    signing.checking = nullptr;
    link.parser.forgetSignature();
}

bool onSetupSigning(Link& link, const mavlink::Frame& frame) {
    if (!isUsb(link) || vehicle.armed) {
        sendStatusText(Severity::warning,
                       STATUS_TEXT("Signing key refused: only over USB, disarmed"));
        return true;
    }
    const auto setup = frame.read<mavlink::SetupSigning>();
    const bool clears = isZero(setup.secret_key);
    for (; signing.step < kSteps; ++signing.step)
        if (storeStep(signing.step, setup, clears) != Status::ok) return false;
    signing.step = 0;
    signing.key = Key::unknown;
    sendStatusText(Severity::notice,
                   clears ? STATUS_TEXT("Signing: no key") : STATUS_TEXT("Signing: key stored"));
    return true;
}

bool refuseSetupSigning(Link&, const mavlink::Frame&) {
    signing.step = 0;
    sendStatusText(Severity::error, STATUS_TEXT("Signing key not stored: again, please"));
    return true;
}

}  // namespace gcs
}  // namespace firmware
