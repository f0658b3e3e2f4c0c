// SPDX-License-Identifier: GPL-3.0-or-later
// Frames that claim to be signed, and any bytes, over the radio of a vehicle that has a key which
// nobody here knows: whatever comes, nothing is answered but by what the vehicle says by itself.
#include <string.h>

#include "firmware/gcs/signing.hpp"
#include "hal/eeprom.hpp"
#include "storage/eeprom_map.hpp"
#include "vehicle.hpp"

namespace {

constexpr uint8_t kRadio = 1;

void storeKey() {
    uint8_t key[34];
    for (uint8_t i = 0; i < 32; ++i) key[i] = static_cast<uint8_t>(151 * i + 23);
    key[32] = 0x5A;  // there is one
    key[33] = 0xC3;
    for (uint8_t i = 0; i < sizeof key; ++i)
        fakes::setEepromCell(static_cast<uint16_t>(storage::kSigning.begin + i), key[i]);
}

// Makes the checksum of the frame right that begins with these bytes, if one does: how many they
// are with its signature.
size_t mend(std::vector<uint8_t>& bytes, size_t at) {
    if (bytes.size() < at + mavlink::kHeaderV2 || bytes[at] != mavlink::kMagicV2) return 1;
    const size_t length = bytes[at + 1], end = at + mavlink::kHeaderV2 + length;
    if (bytes.size() < end + mavlink::kChecksum) return 1;
    mavlink::Accepted accepted;
    const uint16_t id = static_cast<uint16_t>(bytes[at + 7] | bytes[at + 8] << 8);
    if (firmware::gcs::IncomingTable::find(id, accepted) == mavlink::kNoRow) return 1;
    uint16_t crc =
        core::crc16(core::kCrcStart, &bytes[at + 1], static_cast<uint16_t>(end - at - 1));
    crc = core::crc16(crc, accepted.crc_extra);
    bytes[end] = static_cast<uint8_t>(crc);
    bytes[end + 1] = static_cast<uint8_t>(crc >> 8);
    return mavlink::kHeaderV2 + length + mavlink::kChecksum;
}

void checkSilent() {
    static mavlink::PeerParser parser;
    for (const uint8_t byte : fuzz::line(kRadio).out)
        for (bool whole = parser.put(byte); whole; whole = parser.next()) {
            const uint16_t id = parser.frame().id;
            fuzz::require(id != mavlink::Wire<mavlink::Ping>::id &&
                          id != mavlink::Wire<mavlink::ParamValue>::id &&
                          id != mavlink::Wire<mavlink::CommandAck>::id &&
                          id != mavlink::Wire<mavlink::MissionAck>::id &&
                          id != mavlink::Wire<mavlink::MissionCount>::id &&
                          id != mavlink::Wire<mavlink::Timesync>::id);
        }
    fuzz::line(kRadio).out.clear();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
    fuzz::calm();
    storeKey();
    firmware::state::parameters.sign_policy = 1 + (size & 1);
    firmware::gcs::telemetryStart();
    std::vector<uint8_t> all(bytes, bytes + size);
    for (size_t at = 0; at < all.size();) at += mend(all, at);
    fuzz::line(kRadio).receive(all);
    for (int i = 0; i < 16; ++i) fuzz::turn();
    fakes::advance_ms(2000);
    for (int i = 0; i < 4; ++i) fuzz::turn();
    fuzz::require(!firmware::state::vehicle.armed);
    checkSilent();
    return 0;
}
