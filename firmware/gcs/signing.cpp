// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/signing.hpp"

#include <string.h>

#include "core/file_state.hpp"
#include "core/rom.hpp"
#include "core/seldom.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/gcs/signature_hash.hpp"
#include "firmware/gcs/signing_outgoing.hpp"
#include "firmware/gcs/signing_store.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace gcs {

using namespace notify;
using namespace state;

namespace {

using core::Status;

constexpr uint32_t kMinute = 91;  // of a time's upper 32 bits

struct Stream {  // what has one count of time: a link of a component
    uint8_t link, system, component;
    uint16_t lower;
    uint32_t upper;  // 0: none
};
constexpr uint8_t kStreams = 2;

struct Signing {
    bool begun;            // what is stored has been read
    bool signs;            // a link does
    const Link* checking;  // whose frame; nullptr: none
    uint8_t taken;         // bytes of its signature
    Signature signature;
    uint32_t floor;  // a stream that is not known begins after this
    Stream streams[kStreams];
};
core::FileState<Signing> signing{};

// False: the EEPROM is busy.
SELDOM bool begin() {
    if (signingKey() == Key::unknown) return false;
    memset(signing.streams, 0, sizeof signing.streams);
    signing.floor = storedTime(Times::received);
    outgoingSigningStart();
    signing.begun = true;
    return true;
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
    if (!signsLinks()) return true;
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

void record(const mavlink::Frame& frame) {
    Stream* const known = streamOf(frame);
    Stream& stream = known != nullptr ? *known : place();
    stream = {signing.signature.link, frame.system, frame.component, signing.signature.lower,
              signing.signature.upper};
}

uint8_t sizeOf(const mavlink::Frame& frame) {
    return static_cast<uint8_t>(mavlink::kHeaderV2 + frame.length + mavlink::kChecksum);
}

// One slice.
Hashing hashOn(const mavlink::Frame& frame) {
    const uint8_t size = sizeOf(frame);
    return hashSignature(HashUser::received, {frame.payload - mavlink::kHeaderV2, size,
                                              reinterpret_cast<const uint8_t*>(&signing.signature),
                                              static_cast<uint8_t>(size + kSignatureHashed)});
}

bool hashFits() {
    uint8_t differs = 0;  // looked at whole: the time it takes says nothing
    for (uint8_t i = 0; i < sizeof signing.signature.hash; ++i)
        differs |= static_cast<uint8_t>(signatureHash(i) ^ signing.signature.hash[i]);
    return differs == 0;
}

Verdict check(Link& link, const mavlink::Frame& frame) {
    if (signing.checking == nullptr) {
        signing.checking = &link;
        signing.taken = 0;
    }
    if (signing.checking != &link || !takeSignature(link)) return Verdict::waits;
    if (!isLater(frame)) return Verdict::refused;
    const Hashing hashing = hashOn(frame);
    if (hashing == Hashing::waits) return Verdict::waits;
    if (hashing == Hashing::works) return Verdict::works;
    if (!hashFits()) return Verdict::refused;
    if (!storeAhead(Times::received, signing.signature.upper)) return Verdict::waits;
    record(frame);
    outgoingTimeAtLeast(signing.signature.upper);
    return Verdict::obeyed;
}

}  // namespace

void signingStart() {
    signing.checking = nullptr;
    signatureHashStart();
    signingStoreStart();
    signing.begun = begin();
    signingTick();
}

void signingTick() {
    if (!signing.begun) begin();
    const bool wanted = signsLinks();
    if (!wanted && !signing.signs) return;
    signing.signs = wanted;
    for (Link& link : links) {
        // what goes out behind a frame that waits for its signature is signed, too
        const bool signs = wanted || hal::linkHeldSize(portOf(link)) != 0;
        link.signature = signs ? mavlink::kSignature : 0;
        if (signs) signing.signs = true;
    }
}

SELDOM Verdict signingVerdict(Link& link, const mavlink::Frame& frame) {
    if (!signing.begun && !begin()) return Verdict::waits;
    if (mayBeUnsigned(link, frame.id)) return Verdict::obeyed;
    if (!link.parser.isSigned()) return Verdict::refused;
    return check(link, frame);
}

void signingForget(Link& link) {
    if (signing.checking != &link) return;
    signing.checking = nullptr;
    releaseSignatureHash(HashUser::received);
    link.parser.forgetSignature();
}

bool onSetupSigning(Link& link, const mavlink::Frame& frame) {
    if (!isUsb(link) || vehicle.armed) {
        sendStatusText(Severity::warning,
                       STATUS_TEXT("Signing key refused: only over USB, disarmed"));
        return true;
    }
    const auto setup = frame.read<mavlink::SetupSigning>();
    if (storeSigningKey(setup) != Status::ok) return false;
    signing.begun = false;
    sendStatusText(Severity::notice, isZeroKey(setup.secret_key)
                                         ? STATUS_TEXT("Signing: no key")
                                         : STATUS_TEXT("Signing: key stored"));
    return true;
}

bool refuseSetupSigning(Link&, const mavlink::Frame&) {
    giveUpSigningKey();
    sendStatusText(Severity::error, STATUS_TEXT("Signing key not stored: again, please"));
    return true;
}

}  // namespace gcs
}  // namespace firmware
