// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/document_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace simulator {
namespace {

constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr double kMaxSteps = 32767;

void append(std::vector<uint8_t>& bytes, uint32_t value, int count) {
    for (int i = 0; i < count; ++i) bytes.push_back(static_cast<uint8_t>(value >> (8 * i)));
}

}  // namespace

std::string base64(const std::vector<uint8_t>& bytes) {
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (size_t at = 0; at < bytes.size(); at += 3) {
        const size_t left = std::min<size_t>(3, bytes.size() - at);
        uint32_t group = 0;
        for (size_t i = 0; i < 3; ++i) group = group << 8 | (i < left ? bytes[at + i] : 0u);
        for (size_t i = 0; i < 4; ++i)
            text += i <= left ? kDigits[group >> (18 - 6 * i) & 63] : '=';
    }
    return text;
}

Steps stepsOf(const std::vector<double>& values) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const double value : values) {
        if (!std::isfinite(value)) continue;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    Steps steps;
    if (least > most) least = most = 0;
    steps.offset = least + (most - least) / 2;
    steps.scale = (most - least) / (2 * kMaxSteps);
    std::vector<uint8_t> bytes;
    for (const double value : values) {
        const double step = steps.scale > 0 ? (value - steps.offset) / steps.scale : 0;
        const double whole = std::clamp(std::round(step), -kMaxSteps, kMaxSteps);
        const int16_t stored = std::isfinite(value) ? static_cast<int16_t>(whole) : Steps::kNoStep;
        append(bytes, static_cast<uint16_t>(stored), 2);
    }
    steps.base64 = base64(bytes);
    return steps;
}

std::string floatsOf(const std::vector<double>& values) {
    std::vector<uint8_t> bytes;
    for (const double value : values) {
        const auto narrow = static_cast<float>(value);
        uint32_t bits;
        std::memcpy(&bits, &narrow, sizeof bits);
        append(bytes, bits, 4);
    }
    return base64(bytes);
}

}  // namespace simulator
