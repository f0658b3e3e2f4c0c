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
    {'-', '-'}, {'m', 'e'}, {' ', 'T'}, {'S', ','}, {'i', 0x81}, {' ', 'F'}, {' ', 'Q'},
    {' ', 's'}, {'U', 0x83}, {0x82, 0x84}, {0x89, 0x88}, {',', 'C'}, {'B', 'B'}, {'c', 'c'},
    {',', 'A'}, {',', 'L'}, {'H', 'H'}, {'d', 'e'}, {0x85, 0x80}, {'l', 't'}, {'a', 't'},
    {',', 'M'}, {',', 'P'}, {'G', 'G'}, {'Y', 'Y'}, {'i', 't'}, {0x87, 0x80}, {0x8A, 'I'},
    {'0', '0'}, {'f', 'f'}, {'n', 'g'}, {0x85, '-'}, {',', 'G'}, {',', 'R'}, {'C', 'C'},
    {'e', 's'}, {'l', 'l'}, {0x86, 'B'}, {0x8E, 0x93}, {0x91, 'g'}, {'/', 's'}, {'N', 'a'},
    {'d', 'd'}, {'h', 'h'}, {'r', 'm'}, {'s', ','}, {0x80, 0x80}, {0x87, '#'}, {0x90, 0x90},
    {0x9A, 0x92}, {'-', 0x8A}, {'-', 0x92}, {'D', 'U'}, {'L', 'L'}, {'T', 0x86}, {'a', 'g'},
    {'c', 'h'}, {'o', 0xA4}, {0x8C, 0x8C}, {0x8F, 0x9E}, {0x94, 0xBB}, {0x96, 0xAC},
    {0x98, 0x98}, {0x99, 0xB8}, {0xB4, 'm'}, {0xBC, 0xA6}, {',', 'F'}, {',', 'O'}, {',', 'T'},
    {',', 0xA9}, {'-', 0x9F}, {'-', 0xC0}, {'B', 0x8A}, {'C', 0x87}, {'D', 0xA3}, {'I', 'd'},
    {'M', 0x86}, {'N', 0x86}, {'P', 'O'}, {'P', 'S'}, {'T', 'U'}, {'a', 'd'}, {'f', 's'},
    {'n', 's'}, {'o', 0x91}, {'s', 's'}, {'u', 'm'}, {'y', 'r'}, {0x8E, 0x8D}, {0x8F, 0xC1},
    {0x95, 0xB7}, {0x9B, 'd'}, {0xA0, 0xD7}, {0xB1, 0x8A}, {0xB5, 'e'}, {0xC3, 0xD2},
};
// clang-format on

}  // namespace logger
}  // namespace firmware
