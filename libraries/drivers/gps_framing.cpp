// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/gps_framing.hpp"

#include <string.h>

namespace drivers {
namespace {

constexpr uint8_t kUblox = 0xB5, kMtk16 = 0xD0, kMtk19 = 0xD1, kNmea = '$';
constexpr uint8_t kUbloxHeader = 6, kMtkHeader = 3, kChecksum = 2;
constexpr uint8_t kMtkPayload = 32;
constexpr uint8_t kSentenceBegun = 6;  // "$GPGGA": no noise any more

bool begins(uint8_t byte) {
    return byte == kNmea || byte == kUblox || byte == kMtk16 || byte == kMtk19;
}

// Fletcher's over [from, sums).
bool sumsAreRight(const uint8_t* from, const uint8_t* sums) {
    uint8_t a = 0, b = 0;
    for (; from < sums; ++from) {
        a = static_cast<uint8_t>(a + *from);
        b = static_cast<uint8_t>(b + a);
    }
    return a == sums[0] && b == sums[1];
}

uint8_t hex(uint8_t digit) {
    if (digit >= '0' && digit <= '9') return digit - '0';
    digit |= 0x20;
    return digit >= 'a' && digit <= 'f' ? digit - 'a' + 10 : 0xFF;
}

// NMEA 0183: the exclusive or of all between '$' and '*'.
bool sentenceIsRight(const uint8_t* sentence, uint8_t size) {
    constexpr uint8_t kShortest = 10;  // $GPGGA*hh
    if (size + 1 < kShortest || sentence[size - 3] != '*') return false;
    uint8_t sum = 0;
    for (uint8_t i = 1; i < size - 3; ++i) sum ^= sentence[i];
    const uint8_t high = hex(sentence[size - 2]), low = hex(sentence[size - 1]);
    return high < 16 && low < 16 && sum == static_cast<uint8_t>(high << 4 | low);
}

}  // namespace

GpsProtocol GpsFraming::put(uint8_t byte) {
    if (size_ == 0) {
        if (!begins(byte)) return GpsProtocol::none;
        wanted_ = 2;
        seen_ = 1;
    }
    bytes_[size_++] = byte;
    return size_ < wanted_ ? GpsProtocol::none : look();
}

GpsProtocol GpsFraming::next() {
    if (whole_ == 0) return GpsProtocol::none;
    drop(whole_);
    whole_ = 0;
    return look();
}

GpsProtocol GpsFraming::look() {
    while (size_ > 0) {
        wanted_ = wantedSize();
        if (wanted_ > size_) return GpsProtocol::none;
        if (wanted_ != kRefused) {
            whole_ = wanted_;
            return protocol();
        }
        drop(1);
    }
    return GpsProtocol::none;
}

// Size of the message as far as it is known by now, or kRefused.
uint8_t GpsFraming::wantedSize() {
    if (bytes_[0] == kNmea) return sentenceSize();
    return bytes_[0] == kUblox ? binarySize(0x62, kUbloxHeader) : binarySize(0xDD, kMtkHeader);
}

uint8_t GpsFraming::binarySize(uint8_t second, uint8_t header) {
    if (size_ < 2) return 2;
    if (bytes_[1] != second) return kRefused;
    if (size_ < header) return header;
    uint8_t payload = kMtkPayload;
    if (header == kUbloxHeader) {
        payload = bytes_[4];
        if (bytes_[5] != 0 || payload > kLongest - kUbloxHeader - kChecksum) return kRefused;
    } else if (bytes_[2] != kMtkPayload) {
        return kRefused;
    }
    const uint8_t whole = header + payload + kChecksum;
    if (size_ < whole) return whole;
    return sumsAreRight(bytes_ + 2, bytes_ + whole - kChecksum) ? whole : refuse();
}

uint8_t GpsFraming::sentenceSize() {
    for (; seen_ < size_; ++seen_) {
        const uint8_t byte = bytes_[seen_];
        if (byte == '\r' || byte == '\n')
            return sentenceIsRight(bytes_, seen_) ? seen_ + 1 : refuse();
        if (byte < ' ' || byte > '~' || byte == kNmea)
            return seen_ < kSentenceBegun ? kRefused : refuse();
    }
    return seen_ < kLongest ? seen_ + 1 : refuse();
}

uint8_t GpsFraming::refuse() {
    if (++refused_ == 0) --refused_;
    return kRefused;
}

GpsProtocol GpsFraming::protocol() const {
    switch (bytes_[0]) {
        case kUblox:
            return GpsProtocol::ublox;
        case kMtk16:
            return GpsProtocol::mtk16;
        case kMtk19:
            return GpsProtocol::mtk19;
        default:
            return GpsProtocol::nmea;
    }
}

// And all behind it that begins nothing.
void GpsFraming::drop(uint8_t size) {
    while (size < size_ && !begins(bytes_[size])) ++size;
    size_ -= size;
    memmove(bytes_, bytes_ + size, size_);
    seen_ = 1;
}

}  // namespace drivers
