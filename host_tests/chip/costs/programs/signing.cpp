// SPDX-License-Identifier: GPL-3.0-or-later
// SHA-256 of one block, with interrupts off: all of it, and what one slice takes. Then a frame
// whose signature is checked, on the radio's link with a key stored, and one that is signed.
#include <avr/interrupt.h>

#include "crypto/sha256.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/gcs/signing.hpp"
#include "firmware/gcs/signing_outgoing.hpp"
#include "hal/eeprom.hpp"
#include "steps.hpp"
#include "storage/eeprom_map.hpp"

namespace {

crypto::Sha256 sha;
constexpr mavlink::Layout kPosition ROM = mavlink::layoutOf<mavlink::GlobalPositionInt>();

void fill() {
    sha.byte(0) = 'a';
    sha.byte(1) = 'b';
    sha.byte(2) = 'c';
    sha.pad(0, 3);
}

// The EEPROM is blank: a key of ones, and the mark that there is one.
void storeKey() {
    constexpr uint16_t kMark = 0xC35A;
    sei();
    bool ok =
        hal::eepromWrite(storage::kSigning.begin + 32, &kMark, sizeof kMark) == core::Status::ok;
    while (!hal::eepromDrained()) {
    }
    cli();
    if (!ok) costs::broken();
    firmware::gcs::signingStart();
}

// A COMMAND_LONG and 13 bytes of signature: what the parser has room for.
void receive(firmware::gcs::Link& link) {
    mavlink::CommandLong command = {};
    command.confirmation = 1;  // the last byte
    const mavlink::Outgoing message = mavlink::outgoing(mavlink::Framing::v2, command);
    uint8_t header[mavlink::kHeaderV2];
    mavlink::writeHeader({mavlink::Framing::v2, 0, 255, 190}, message, header);
    header[2] = mavlink::kSignedFlag;
    uint16_t crc = core::crc16(core::kCrcStart, header + 1, sizeof header - 1);
    crc = core::crc16(core::crc16(crc, message.payload, message.length), message.crc_extra);
    for (const uint8_t byte : header) link.parser.put(byte);
    for (uint8_t i = 0; i < message.length; ++i) link.parser.put(message.payload[i]);
    link.parser.put(static_cast<uint8_t>(crc));
    if (!link.parser.put(static_cast<uint8_t>(crc >> 8))) costs::broken();
    for (uint8_t i = 0; i < mavlink::kSignature; ++i) link.parser.put(1);
}

void checkOne() {
    firmware::gcs::Link& link = firmware::gcs::links[1];
    receive(link);
    const mavlink::Frame frame = link.parser.frame();
    firmware::gcs::Verdict verdict = firmware::gcs::Verdict::works;
    while (verdict == firmware::gcs::Verdict::works)
        costs::timed(costs::kCheckSlice,
                     [&] { verdict = firmware::gcs::signingVerdict(link, frame); });
    if (verdict != firmware::gcs::Verdict::refused) costs::broken();
    firmware::gcs::signingForget(link);
}

// From its request on; what sends it is in the costs of the link.
void signOne() {
    firmware::gcs::Link& link = firmware::gcs::links[1];
    mavlink::GlobalPositionInt message = {};
    message.hdg = 0x1234;  // the last bytes
    if (!firmware::gcs::sendPayload(link, &message, kPosition)) costs::broken();
    bool more = true;
    while (more) costs::timed(costs::kSignSlice, [&] { more = firmware::gcs::signOutgoing(link); });
    if (hal::linkHeldSize(hal::Port::link1) != 0) costs::broken();
}

}  // namespace

int main() {
    hal::trace(hal::kTraceFrameBegin);  // without frames nothing is measured
    sha.begin();
    fill();
    costs::timed(costs::kHashBlock, [] {
        while (!sha.quarter()) {
        }
    });
    if (sha.hash(0) != 0xba || sha.hash(31) != 0xad) costs::broken();
    sha.begin();
    fill();
    for (uint8_t i = 0; i < crypto::kQuarters; ++i)
        costs::timed(costs::kHashQuarter, [] { sha.quarter(); });
    firmware::state::parameters.sign_policy = 1;
    storeKey();
    checkOne();
    signOne();
    for (uint8_t i = 0; i < 8; ++i) costs::timed(costs::kNothing, [] {});
    for (;;) {
    }
}
