// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/sha256.hpp"

#include <array>
#include <cstdint>
#include <cstdio>

namespace simulator {
namespace {

constexpr size_t kBlock = 64;

constexpr std::array<uint32_t, 64> kRound = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

uint32_t rotated(uint32_t value, int right) { return value >> right | value << (32 - right); }

uint32_t mixed(uint32_t value, int first, int second, int third) {
    return rotated(value, first) ^ rotated(value, second) ^ rotated(value, third);
}

using State = std::array<uint32_t, 8>;

std::array<uint32_t, 64> scheduleOf(const char* block) {
    std::array<uint32_t, 64> words{};
    for (size_t i = 0; i < kBlock; ++i)
        words[i / 4] = words[i / 4] << 8 | static_cast<uint8_t>(block[i]);
    for (size_t i = 16; i < words.size(); ++i) {
        const uint32_t far = words[i - 15], near = words[i - 2];
        words[i] = words[i - 16] + (rotated(far, 7) ^ rotated(far, 18) ^ far >> 3) + words[i - 7] +
                   (rotated(near, 17) ^ rotated(near, 19) ^ near >> 10);
    }
    return words;
}

void addBlock(State& state, const char* block) {
    const auto words = scheduleOf(block);
    auto [a, b, c, d, e, f, g, h] = state;
    for (size_t i = 0; i < words.size(); ++i) {
        const uint32_t choice = (e & f) ^ (~e & g), majority = (a & b) ^ (a & c) ^ (b & c);
        const uint32_t first = h + mixed(e, 6, 11, 25) + choice + kRound[i] + words[i];
        const uint32_t second = mixed(a, 2, 13, 22) + majority;
        h = g, g = f, f = e, e = d + first, d = c, c = b, b = a, a = first + second;
    }
    const State sum = {a, b, c, d, e, f, g, h};
    for (size_t i = 0; i < state.size(); ++i) state[i] += sum[i];
}

// A one, zeros to the end of a block, and there the length in bits.
std::string padded(const std::string& bytes) {
    std::string all = bytes + '\x80';
    while (all.size() % kBlock != kBlock - 8) all += '\0';
    const uint64_t bits = uint64_t{bytes.size()} * 8;
    for (int shift = 56; shift >= 0; shift -= 8) all += static_cast<char>(bits >> shift);
    return all;
}

}  // namespace

std::string sha256(const std::string& bytes) {
    State state = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                   0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
    const std::string all = padded(bytes);
    for (size_t at = 0; at < all.size(); at += kBlock) addBlock(state, &all[at]);
    std::string text;
    for (const uint32_t word : state) {
        char digits[9];
        std::snprintf(digits, sizeof digits, "%08x", word);
        text += digits;
    }
    return text;
}

}  // namespace simulator
