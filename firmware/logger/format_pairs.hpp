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
    {'m', 'e'}, {'-', ' '}, {' ', 's'}, {'S', ','}, {'T', 'i'}, {0x84, 0x80}, {' ', 'Q'},
    {'U', 0x83}, {0x85, 0x87}, {'B', 'B'}, {'-', '-'}, {',', 'C'}, {'c', 'c'}, {0x81, 0x88},
    {' ', 'F'}, {',', 'A'}, {'d', 'e'}, {'t', ','}, {0x81, 'F'}, {' ', 0x88}, {'f', 'f'},
    {'H', 'H'}, {'0', '0'}, {'d', 'd'}, {'h', ','}, {'i', 't'}, {',', 'M'}, {'G', 'G'},
    {'Y', 'Y'}, {'n', 'g'}, {0x86, 'B'}, {0x92, '-'}, {',', 'L'}, {'C', 'C'}, {'l', 'l'},
    {0x82, '#'}, {0x89, 0x89}, {0x8F, 'l'}, {' ', 0x90}, {',', 'G'}, {',', 'P'}, {'I', 'd'},
    {'e', 's'}, {0x82, '-'}, {0xA5, 0x91}, {0xA6, 'g'}, {',', 'V'}, {'/', 's'}, {'D', 'U'},
    {'L', 'L'}, {'L', 0x9D}, {'N', 'a'}, {'R', 'o'}, {'a', 't'}, {'a', 0x91}, {'c', 0x98},
    {'h', 'h'}, {'m', 'n'}, {'r', 'm'}, {'s', 'p'}, {0x89, 0x93}, {0x8A, 0x8A}, {0x95, 0x95},
    {0x99, 0xB7}, {0x9F, 0x8D}, {0xAB, 0xC0}, {0xB2, 0xAC}, {0xB4, 0xA2}, {0xB6, 0xC2},
    {',', 'F'}, {'C', 0x82}, {'P', 0xBF}, {'T', 0x86}, {'a', 'g'}, {'b', 'e'}, {'l', 't'},
    {'s', ','}, {0x8A, '-'}, {0x8C, 0x8C}, {0x8E, '-'}, {0x90, 'm'}, {0x94, 0x94}, {0x97, 0x97},
    {0x9C, 0x9C}, {0xA8, 0xBA}, {0xB0, 'm'}, {0xB1, 'e'}, {0xBD, 0xCD}, {0xC3, ','}, {' ', 'm'},
    {',', 'O'}, {'A', 'R'}, {'B', 0x93}, {'D', 0xAA}, {'M', 'U'}, {'M', 0x86}, {'N', 0x86},
    {'P', 'O'}, {'P', 'S'}, {'R', 0x86}, {'T', 'U'}, {'Y', 'a'}, {'a', 'd'}, {'f', 's'},
    {'i', 0xCA}, {'o', 0x90}, {'y', 'r'}, {0x8C, 0xC6}, {0x8D, 'C'}, {0x8D, 'I'}, {0x8E, 0xA4},
    {0x8F, 0x8C}, {0x92, 0x8A}, {0x93, 'I'}, {0x9A, 0xC9}, {0x9B, 0xA4}, {0xA0, 0xC4},
    {0xA7, 0xEA}, {0xAE, 0xE8}, {0xB3, 'v'}, {0xD0, ','}, {0xDA, 0xE7}, {0xE5, 'w'},
    {0xEE, 0xBC},
};
// clang-format on

}  // namespace logger
}  // namespace firmware
