// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/image.hpp"

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <sstream>

#include "hal/eeprom.hpp"
#include "toolchain/mission_tool/wrong_input.hpp"

namespace mission_tool {
namespace {

constexpr size_t kBytesPerLine = 16;

// Intel, Hexadecimal Object File Format Specification, revision A: record types.
enum Type : uint8_t {
    kData = 0,
    kEnd = 1,
    kSegment = 2,
    kStartSegment = 3,
    kLinear = 4,
    kStart = 5
};

class HexLine {
public:
    HexLine(const std::string& text, const std::string& name, int number)
        : text_(text), name_(name), number_(number) {
        if (text_[0] != ':') fail(0, "':'");
        for (size_t at = 1; at < text_.size(); at += 2) bytes_.push_back(byteAt(at));
        constexpr size_t kShortest = 5;  // length, address, type, checksum
        if (bytes_.size() < kShortest || bytes_.size() != kShortest + bytes_[0]) {
            fail(1, "a length that agrees with the line's");
        }
        if (std::accumulate(bytes_.begin(), bytes_.end(), 0u) % 256 != 0) {
            fail(text_.size() - 2, "the line's checksum");
        }
    }

    Type type() const { return static_cast<Type>(bytes_[3]); }

    void putInto(Image& image) const {
        const size_t address = bytes_[1] * 256u + bytes_[2];
        if (address + bytes_[0] > image.size()) fail(3, "an address within 4096 bytes");
        std::copy(bytes_.begin() + 4, bytes_.end() - 1,
                  image.begin() + static_cast<ptrdiff_t>(address));
    }
    // An EEPROM lies in the first segment.
    void checkBase() const {
        if (std::any_of(bytes_.begin() + 4, bytes_.end() - 1, [](uint8_t b) { return b != 0; })) {
            fail(9, "a base address of 0");
        }
    }
    [[noreturn]] void fail(size_t at, const std::string& what) const {
        throw WrongInput(placed(name_, number_, static_cast<int>(at) + 1,
                                expected(what, at < text_.size() ? text_.substr(at, 2) : "")));
    }

private:
    uint8_t byteAt(size_t at) const {
        const std::string pair = text_.substr(at, 2);
        const auto digit = [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; };
        if (pair.size() != 2 || !digit(pair[0]) || !digit(pair[1])) fail(at, "two hex digits");
        return static_cast<uint8_t>(std::stoi(pair, nullptr, 16));
    }

    const std::string& text_;
    const std::string& name_;
    int number_;
    std::vector<uint8_t> bytes_;
};

}  // namespace

Image blankImage() { return Image(hal::kEepromSize, 0xFF); }

bool looksLikeHex(const std::string& contents) {
    return !contents.empty() && contents[0] == ':' &&
           std::all_of(contents.begin(), contents.end(), [](unsigned char c) {
               return c < 127 && (c >= 32 || std::isspace(c) != 0);
           });
}

Image parseHex(const std::string& text, const std::string& name) {
    Image image = blankImage();
    std::istringstream lines(text);
    std::string line;
    int number = 0;
    while (std::getline(lines, line)) {
        ++number;
        line.erase(line.find_last_not_of(" \t\r") + 1);
        if (line.empty()) continue;
        const HexLine hex(line, name, number);
        switch (hex.type()) {
            case kData:
                hex.putInto(image);
                break;
            case kSegment:
            case kLinear:
                hex.checkBase();
                break;
            case kStartSegment:
            case kStart:
                break;
            case kEnd:
                return image;
            default:
                hex.fail(7, "a record type of 0 to 5");
        }
    }
    throw WrongInput(placed(name, number + 1, 1, expected("the end record ':00000001FF'", "")));
}

std::string hexOf(const Image& image) {
    std::string text;
    const auto put = [&text](std::vector<uint8_t> bytes) {
        const unsigned sum = std::accumulate(bytes.begin(), bytes.end(), 0u);
        bytes.push_back(static_cast<uint8_t>(0u - sum));
        text += ':';
        for (uint8_t byte : bytes) {
            char digits[3];
            std::snprintf(digits, sizeof digits, "%02X", byte);
            text += digits;
        }
        text += '\n';
    };
    for (size_t at = 0; at < image.size(); at += kBytesPerLine) {
        const size_t size = std::min(kBytesPerLine, image.size() - at);
        std::vector<uint8_t> bytes = {static_cast<uint8_t>(size), static_cast<uint8_t>(at >> 8),
                                      static_cast<uint8_t>(at), kData};
        const auto from = image.begin() + static_cast<ptrdiff_t>(at);
        bytes.insert(bytes.end(), from, from + static_cast<ptrdiff_t>(size));
        put(bytes);
    }
    put({0, 0, 0, kEnd});
    return text;
}

std::string rawOf(const Image& image) { return {image.begin(), image.end()}; }

std::string encodedFor(const std::string& path, const Image& image) {
    const size_t dot = path.rfind('.');
    const std::string end = dot == std::string::npos ? "" : path.substr(dot);
    if (end == ".eep" || end == ".hex") return hexOf(image);
    if (end == ".bin") return rawOf(image);
    throw WrongInput(path +
                     ": expected a name that ends in .eep or .hex (Intel hex) or .bin (raw)");
}

}  // namespace mission_tool
