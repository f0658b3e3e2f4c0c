// SPDX-License-Identifier: GPL-3.0-or-later
// The pairs by which the log's formats and units are packed, code 0x80 and on.
// Made by toolchain/texts/main.mjs.
#pragma once
#include "core/packed_text.hpp"

namespace firmware {
namespace logger {

// Only for the compiler: what is read in flight lies in flash.
// clang-format off
constexpr core::CodePair kFormatPairs[] = {
    {'-', '-'}, {'m', 'e'}, {' ', 'T'}, {',', 'C'}, {'i', 0x81}, {' ', 'F'}, {' ', 'Q'},
    {' ', 's'}, {'U', 'S'}, {0x82, 0x84}, {0x89, 0x88}, {0x8A, ','}, {',', 'A'}, {'H', 'H'},
    {'c', 'c'}, {'d', 'e'}, {',', 'L'}, {'0', '0'}, {'B', 'B'}, {'f', 'f'}, {0x85, 0x80},
    {'a', 't'}, {'i', 't'}, {'l', 't'}, {',', 'P'}, {'G', 'G'}, {'Y', 'Y'}, {0x83, 'h'},
    {0x87, 0x80}, {',', 'G'}, {',', 'M'}, {'h', 'h'}, {'l', 'l'}, {'n', 'g'}, {'C', 'C'},
    {'I', 'd'}, {'e', 's'}, {0x8F, 'g'}, {',', 'N'}, {',', 'R'}, {'/', 's'}, {'c', 'h'},
    {'d', 'd'}, {'o', 0xA0}, {'r', 'm'}, {0x80, 0x80}, {0x8C, 0x97}, {0x8D, 0x8D}, {0x94, 0x8B},
    {0x96, 0xA9}, {0x9C, 0xB0}, {',', 'V'}, {'-', 0x8B}, {'0', 0x8B}, {'D', 'U'}, {'L', 'L'},
    {'T', 0x86}, {'a', 'g'}, {'f', 0x87}, {'p', 'd'}, {'r', 'r'}, {0x8C, 0x8E}, {0x90, 0x95},
    {0x90, 0xA1}, {0x98, 0xAC}, {0x9A, 0x9A}, {0xBE, 0xBF}, {',', 'D'}, {',', 'F'}, {',', 'O'},
    {',', 'T'}, {'-', 0x85}, {'-', 0x94}, {'-', 0x99}, {'-', 0xB6}, {'M', 0x86}, {'N', 0x86},
    {'P', 'S'}, {'T', 'U'}, {'Y', 'a'}, {'a', 'd'}, {'a', 'v'}, {'a', 0x81}, {'f', 's'},
    {'m', 'n'}, {'o', 'n'}, {'o', 't'}, {'o', 0x8F}, {'r', 'g'}, {'s', 's'}, {'y', 'r'},
    {0x85, 0x91}, {0x86, 'B'}, {0x91, 0xB5}, {0x92, 0x92}, {0x93, 0x93}, {0x98, 0xB1},
    {0xA7, 0xAB}, {0xC2, 0xAE}, {0xC5, 0xD3}, {0xCF, 'w'},
};
// clang-format on

}  // namespace logger
}  // namespace firmware
