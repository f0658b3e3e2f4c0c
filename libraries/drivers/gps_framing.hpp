// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the messages of all GPS protocols in one stream of bytes: UBX and MTK frames and NMEA
// sentences whose checksum is right. What looked like the beginning of one and was none is looked
// through again from its second byte on, so a message behind a damaged one is never lost.
#pragma once
#include <stdint.h>

namespace drivers {

enum class GpsProtocol : uint8_t { none, ublox, mtk16, mtk19, nmea };

class GpsFraming {
public:
    static constexpr uint8_t kLongest = 100;  // NAV-PVT with header and checksum

    // The protocol of the message that stands whole at message(), until put or next is called.
    // Ask next() until there is none before the next put().
    GpsProtocol put(uint8_t byte);
    GpsProtocol next();

    const uint8_t* message() const { return bytes_; }
    uint16_t refused() const { return refused_; }  // wrong checksum, too long, broken off

    void clear() { size_ = whole_ = 0; }

private:
    static constexpr uint8_t kRefused = 0;

    GpsProtocol look();
    uint8_t wantedSize();
    uint8_t binarySize(uint8_t second, uint8_t header);
    uint8_t sentenceSize();
    uint8_t refuse();
    GpsProtocol protocol() const;
    void drop(uint8_t size);

    uint8_t bytes_[kLongest] = {};
    uint16_t refused_ = 0;
    uint8_t size_ = 0;
    uint8_t wanted_ = 0;  // bytes that must be there for the next look
    uint8_t seen_ = 0;    // of a sentence
    uint8_t whole_ = 0;   // size of the message at message()
};

}  // namespace drivers
