// SPDX-License-Identifier: GPL-3.0-or-later
// A ground station that signs, and reads signatures.
#pragma once
#include <algorithm>

#include "crypto/sha256.hpp"
#include "firmware/gcs/link.hpp"
#include "ground.hpp"
#include "storage/eeprom_map.hpp"

namespace ground {

using Texts = std::vector<std::string>;
using Bytes = std::vector<uint8_t>;

// Of node-mavlink: PING from 255/190 by link 3 on 2026-01-01, its key 1, 8, 15 and so on.
const Bytes kPublished = {0xfd, 0x09, 0x01, 0x00, 0x05, 0xff, 0xbe, 0x04, 0x00, 0x00, 0x89, 0x67,
                          0x45, 0x23, 0x01, 0x00, 0x00, 0x00, 0x07, 0xab, 0x4a, 0x03, 0x00, 0xe0,
                          0x3c, 0xd6, 0x92, 0x1f, 0x13, 0x52, 0xf0, 0x0f, 0xf9, 0x75};
constexpr uint64_t kPublishedTime = 0x1f92d63ce000;
constexpr uint64_t kSecond = 100000, kMinute = 60 * kSecond;

inline Bytes keyOf(uint8_t step = 7) {
    Bytes key;
    for (int i = 0; i < 32; ++i) key.push_back(static_cast<uint8_t>(i * step + 1));
    return key;
}

// What stands behind a signed frame.
inline Bytes signatureOf(const Bytes& frame, const Bytes& key, uint8_t link, uint64_t time) {
    Bytes message = key;
    message.insert(message.end(), frame.begin(), frame.end());
    Bytes signature = {link};
    for (int i = 0; i < 6; ++i) signature.push_back(static_cast<uint8_t>(time >> 8 * i));
    message.insert(message.end(), signature.begin(), signature.end());
    crypto::Sha256 sha;
    sha.begin();
    const uint16_t size = static_cast<uint16_t>(message.size());
    for (uint8_t block = 0; block < crypto::blocksOf(size); ++block) {
        for (size_t i = 0; i < 64 && block * 64u + i < size; ++i)
            sha.byte(static_cast<uint8_t>(i)) = message[block * 64u + i];
        sha.pad(block, size);
        while (!sha.quarter()) {
        }
    }
    for (uint8_t i = 0; i < 6; ++i) signature.push_back(sha.hash(i));
    return signature;
}

class Signing : public Telemetry {
protected:
    void SetUp() override {
        Telemetry::SetUp();
        fakes::setUsb(true);
        run_ms(100);
        station.framing = second.framing = Framing::v2;
        station.forget();
        second.forget();
    }

    static mavlink::SetupSigning setup(const Bytes& key, uint64_t time = 0) {
        mavlink::SetupSigning message = {};
        message.target_system = message.target_component = 1;
        message.initial_timestamp = time;
        memcpy(message.secret_key, key.data(), key.size());
        return message;
    }
    void setKey(const Bytes& key = keyOf(), uint64_t time = 0) {
        station.send(setup(key, time));
        run_ms(1000);
        EXPECT_EQ(station.texts(), Texts{"Signing: key stored"});
        second.forget();
    }
    template <class Message>
    static Bytes unsignedFrame(const Message& message, uint8_t system, uint8_t component) {
        Bytes bytes;
        const auto put = [&bytes](const uint8_t* from, uint8_t count) {
            bytes.insert(bytes.end(), from, from + count);
        };
        mavlink::writeFrame(put, {Framing::v2, 5, system, component},
                            mavlink::outgoing(Framing::v2, message));
        return flagged(bytes, mavlink::Wire<Message>::crc_extra);
    }
    template <class Message>
    static Bytes signedFrame(const Message& message, uint64_t time, uint8_t link = 3,
                             const Bytes& key = keyOf(), uint8_t system = 255) {
        Bytes frame = unsignedFrame(message, system, 190);
        const Bytes signature = signatureOf(frame, key, link, time);
        frame.insert(frame.end(), signature.begin(), signature.end());
        return frame;
    }
    static mavlink::Ping aPing() {
        mavlink::Ping message = {};
        message.seq = 7;
        return message;
    }
    static Bytes ping(uint8_t system = 255, uint8_t component = 190) {
        return unsignedFrame(aPing(), system, component);
    }
    // With the flag, and the checksum that belongs to it.
    static Bytes flagged(Bytes frame, uint8_t crc_extra) {
        frame[2] = mavlink::kSignedFlag;
        uint16_t crc =
            core::crc16(core::kCrcStart, frame.data() + 1, static_cast<uint16_t>(frame.size() - 3));
        crc = core::crc16(crc, crc_extra);
        frame[frame.size() - 2] = static_cast<uint8_t>(crc);
        frame[frame.size() - 1] = static_cast<uint8_t>(crc >> 8);
        return frame;
    }
    static Bytes signedPing(uint64_t time, uint8_t link = 3, const Bytes& key = keyOf(),
                            uint8_t system = 255) {
        return signedFrame(aPing(), time, link, key, system);
    }
    // How many of the answers a PING has come over the radio.
    size_t answers(const Bytes& bytes, uint32_t wait_ms = 100) {
        second.line().receive(bytes);
        run_ms(wait_ms);
        return second.all<mavlink::Ping>().size();
    }
    void restart() {
        startAgain();
        second.forget();
        station.forget();
    }
    void startAgain() {
        fakes::restartEeprom();
        firmware::gcs::telemetryStart();
        run_ms(100);
    }
    bool saysDamaged() {
        const Texts texts = second.texts();
        return std::count(texts.begin(), texts.end(), "Signing key or time damaged") != 0;
    }
};

}  // namespace ground
