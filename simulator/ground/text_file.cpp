// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/text_file.hpp"

#include <algorithm>
#include <cstdint>

namespace simulator {
namespace {

constexpr char32_t kReplacement = 0xFFFD;

bool beginsWith(const std::string& bytes, const std::string& mark) {
    return bytes.compare(0, mark.size(), mark) == 0;
}

void appendUtf8(std::string& text, char32_t letter) {
    const auto put = [&text](char32_t byte) { text += static_cast<char>(byte); };
    const auto tail = [&](int shift) { put(0x80 | (letter >> shift & 0x3F)); };
    if (letter < 0x80) return put(letter);
    if (letter < 0x800) {
        put(0xC0 | letter >> 6);
    } else if (letter < 0x10000) {
        put(0xE0 | letter >> 12);
        tail(6);
    } else {
        put(0xF0 | letter >> 18);
        tail(12);
        tail(6);
    }
    tail(0);
}

// The 16-bit units after the mark, in either order of bytes.
std::string fromUtf16(const std::string& bytes, bool big_endian) {
    const auto unit = [&](size_t at) {
        const auto first = static_cast<uint8_t>(bytes[at]);
        const auto second = static_cast<uint8_t>(bytes[at + 1]);
        return static_cast<char32_t>(big_endian ? first << 8 | second : second << 8 | first);
    };
    std::string text;
    for (size_t at = 2; at + 1 < bytes.size(); at += 2) {
        char32_t letter = unit(at);
        const bool leads = letter >= 0xD800 && letter < 0xDC00 && at + 3 < bytes.size();
        const char32_t low = leads ? unit(at + 2) : 0;
        if (low >= 0xDC00 && low < 0xE000) {
            letter = 0x10000 + ((letter - 0xD800) << 10) + (low - 0xDC00);
            at += 2;
        } else if (letter >= 0xD800 && letter < 0xE000) {
            letter = kReplacement;  // half of a pair
        }
        appendUtf8(text, letter);
    }
    return text;
}

// ASCII in units of 16 bits: every other byte is 0, and no others are.
bool looksLikeUtf16(const std::string& bytes) {
    constexpr size_t kEnough = 200;
    const size_t size = std::min(bytes.size(), kEnough) / 2 * 2;
    size_t zeros[2] = {0, 0};
    for (size_t at = 0; at < size; ++at)
        if (bytes[at] == 0) ++zeros[at % 2];
    return size > 8 &&
           ((zeros[0] == size / 2 && zeros[1] == 0) || (zeros[1] == size / 2 && zeros[0] == 0));
}

std::string withoutMark(const std::string& bytes) {
    if (beginsWith(bytes, "\xEF\xBB\xBF")) return bytes.substr(3);
    if (beginsWith(bytes, "\xFF\xFE")) return fromUtf16(bytes, false);
    if (beginsWith(bytes, "\xFE\xFF")) return fromUtf16(bytes, true);
    return bytes;
}

}  // namespace

std::string decodedText(const std::string& bytes) {
    const std::string text = withoutMark(bytes);
    std::string lines;
    for (size_t at = 0; at < text.size(); ++at)
        if (text.compare(at, 2, "\r\n") != 0) lines += text[at];
    return lines;
}

std::string whyNoText(const std::string& bytes) {
    const std::string text = decodedText(bytes);
    if (text.find_first_not_of(" \t\r\n") == text.npos) return "the file is empty";
    if (text.find('\0') == text.npos) return "";
    return looksLikeUtf16(bytes) ? "UTF-16 without a byte order mark: save it as UTF-8"
                                 : "not a text file";
}

std::string printable(const std::string& text) {
    constexpr size_t kMax = 40;
    std::string clean;
    for (const char c : text.substr(0, kMax)) clean += c >= 32 && c < 127 ? c : '?';
    return text.size() > kMax ? clean + "..." : clean;
}

std::string listed(const std::vector<std::string>& errors) {
    std::string text;
    for (size_t i = 0; i < errors.size() && i < kMaxListed; ++i)
        text += (i == 0 ? "" : "\n") + errors[i];
    if (errors.size() > kMaxListed)
        text += "\nand " + std::to_string(errors.size() - kMaxListed) + " more";
    return text;
}

}  // namespace simulator
