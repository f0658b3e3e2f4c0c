// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/ublox_parser.hpp"

#include <cstdio>
#include <utility>

namespace simulator {
namespace {

constexpr uint8_t kSync1 = 0xB5, kSync2 = 0x62;
constexpr size_t kHeader = 6, kChecksum = 2, kLongestPayload = 512, kLongestSentence = 128;

// Fletcher's over class, id, length and payload.
std::pair<uint8_t, uint8_t> ubxChecksum(const std::vector<uint8_t>& bytes, size_t end) {
    uint8_t a = 0, b = 0;
    for (size_t i = 2; i < end; ++i) {
        a = static_cast<uint8_t>(a + bytes[i]);
        b = static_cast<uint8_t>(b + a);
    }
    return {a, b};
}

uint8_t nmeaChecksum(const std::string& body) {
    uint8_t sum = 0;
    for (char c : body) sum = static_cast<uint8_t>(sum ^ static_cast<uint8_t>(c));
    return sum;
}

}  // namespace

uint16_t UbxFrame::u16(size_t at) const {
    return static_cast<uint16_t>(payload.at(at) | payload.at(at + 1) << 8);
}
uint32_t UbxFrame::u32(size_t at) const {
    return u16(at) | static_cast<uint32_t>(u16(at + 2)) << 16;
}

std::vector<uint8_t> ubxBytes(const UbxFrame& frame) {
    const size_t size = frame.payload.size();
    std::vector<uint8_t> bytes;
    bytes.reserve(kHeader + size + kChecksum);
    for (size_t byte : {size_t{kSync1}, size_t{kSync2}, size_t{frame.message_class},
                        size_t{frame.id}, size & 0xFF, size >> 8})
        bytes.push_back(static_cast<uint8_t>(byte));
    for (uint8_t byte : frame.payload) bytes.push_back(byte);
    const auto [a, b] = ubxChecksum(bytes, bytes.size());
    bytes.push_back(a);
    bytes.push_back(b);
    return bytes;
}

std::string nmeaSentence(const std::string& body) {
    char end[8];
    std::snprintf(end, sizeof end, "*%02X\r\n", nmeaChecksum(body));
    return "$" + body + end;
}

void UbloxParser::take(uint8_t byte) {
    if (bytes_.empty() && byte != kSync1 && byte != '$') return;
    // Text has neither of the two: what begins there is another message.
    const bool text = !bytes_.empty() && bytes_[0] == '$';
    if (text && (byte == kSync1 || byte == '$')) bytes_.clear();
    bytes_.push_back(byte);
    bytes_[0] == '$' ? takeNmea() : takeUbx();
}

void UbloxParser::takeUbx() {
    if (bytes_.size() == 2 && bytes_[1] != kSync2) return bytes_.clear();
    if (bytes_.size() < kHeader) return;
    const size_t size = bytes_[4] | bytes_[5] << 8;
    if (size > kLongestPayload) return bytes_.clear();
    if (bytes_.size() < kHeader + size + kChecksum) return;
    const auto [a, b] = ubxChecksum(bytes_, kHeader + size);
    if (bytes_[kHeader + size] == a && bytes_[kHeader + size + 1] == b)
        frame_ = UbxFrame{bytes_[2],
                          bytes_[3],
                          {bytes_.begin() + kHeader,
                           bytes_.begin() + static_cast<std::ptrdiff_t>(kHeader + size)}};
    bytes_.clear();
}

void UbloxParser::takeNmea() {
    if (bytes_.size() > kLongestSentence) return bytes_.clear();
    if (bytes_.back() != '\n') return;
    const std::string line(bytes_.begin() + 1, bytes_.end());
    bytes_.clear();
    const size_t star = line.find('*');
    if (star == std::string::npos) return;
    const std::string body = line.substr(0, star);
    if (nmeaSentence(body).substr(1) == line) sentence_ = body;
}

std::optional<UbxFrame> UbloxParser::frame() { return std::exchange(frame_, std::nullopt); }
std::optional<std::string> UbloxParser::sentence() {
    return std::exchange(sentence_, std::nullopt);
}

}  // namespace simulator
