// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/signing_outgoing.hpp"

#include "core/file_state.hpp"
#include "core/seldom.hpp"
#include "firmware/gcs/gps_time.hpp"
#include "firmware/gcs/signature_hash.hpp"
#include "firmware/gcs/signing_store.hpp"
#include "hal/clock.hpp"

namespace firmware {
namespace gcs {

namespace {

struct Clock {
    uint16_t lower;
    uint32_t upper;
    uint32_t read_ms;
};
core::FileState<Clock> clock{};

constexpr uint8_t kPerMs = 100;  // 10 us each

// No two frames have the same time.
void runOn() {
    const uint32_t now_ms = hal::now_ms();
    uint32_t passed = kPerMs * (now_ms - clock.read_ms);
    if (passed == 0) passed = 1;
    const uint32_t sum = clock.lower + passed;
    clock.lower = static_cast<uint16_t>(sum);
    clock.upper += sum >> 16;
    clock.read_ms = now_ms;
}

uint32_t upperOfGps() {
    constexpr uint32_t kBegan_utc_s = 1420070400;  // 2015
    const UtcTime utc = utcTime();
    if (utc.week_s == 0) return 0;
    const uint32_t since_s = utc.week_s - kBegan_utc_s + utc.since_ms / 1000;
    // 100,000 / 65,536 is 1 + 1077 / 2048, in 32 bits
    return since_s + (since_s >> 11) * 1077 + ((since_s & 2047) * 1077 >> 11);
}

SELDOM bool advance() {
    runOn();
    outgoingTimeAtLeast(upperOfGps());
    return storeAhead(Times::sent, clock.upper);
}

HashUser userOf(const Link& link) {
    return linkNumber(link) == 0 ? HashUser::sent_on_link0 : HashUser::sent_on_link1;
}

void putTime(const hal::Runs& to, uint8_t at, uint8_t link) {
    to[at++] = link;
    to[at++] = static_cast<uint8_t>(clock.lower);
    to[at++] = static_cast<uint8_t>(clock.lower >> 8);
    for (uint8_t shift = 0; shift < 32; shift = static_cast<uint8_t>(shift + 8))
        to[at++] = static_cast<uint8_t>(clock.upper >> shift);
}

}  // namespace

void outgoingSigningStart() {
    clock.lower = 0;
    clock.upper = storedTime(Times::sent) + 1;  // of that one frames may have been sent
    clock.read_ms = hal::now_ms();
    outgoingTimeAtLeast(storedTime(Times::received));
}

void outgoingTimeAtLeast(uint32_t upper) {
    if (upper <= clock.upper) return;
    clock.upper = upper;
    clock.lower = 0;
}

SELDOM bool signOutgoing(Link& link) {
    const hal::Port port = portOf(link);
    if (hal::linkHeldSize(port) == 0) return false;
    const hal::Runs bytes = hal::linkHeld(port);
    const uint8_t size =
        static_cast<uint8_t>(mavlink::frameSize(mavlink::Framing::v2, bytes[mavlink::kLengthAt]));
    const HashUser user = userOf(link);
    if (signatureHashUser() == HashUser::nobody) {
        if (!advance()) return false;
        putTime(bytes, size, linkNumber(link));
    }
    const Hashing hashing = hashSignature(user, {bytes.first, bytes.first_size, bytes.second,
                                                 static_cast<uint8_t>(size + kSignatureHashed)});
    if (hashing != Hashing::done) return hashing == Hashing::works;
    for (uint8_t i = 0; i < sizeof Signature::hash; ++i)
        bytes[static_cast<uint8_t>(size + kSignatureHashed + i)] = signatureHash(i);
    releaseSignatureHash(user);
    hal::linkSendHeld(port, static_cast<uint8_t>(size + mavlink::kSignature));
    return true;
}

}  // namespace gcs
}  // namespace firmware
