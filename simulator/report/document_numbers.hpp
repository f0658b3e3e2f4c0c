// SPDX-License-Identifier: GPL-3.0-or-later
// Long rows of numbers in a flight document: binary in base64, a sixth of what digits would take.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

namespace simulator {

std::string base64(const std::vector<uint8_t>& bytes);

// As steps of 16 bits, little-endian: value = offset + scale * step, so fine that the range of the
// values takes all of them; NaN is kNoStep.
struct Steps {
    static constexpr int16_t kNoStep = -32768;
    double scale = 0, offset = 0;
    std::string base64;
};
Steps stepsOf(const std::vector<double>& values);

std::string floatsOf(const std::vector<double>& values);  // float32, little-endian, base64

}  // namespace simulator
