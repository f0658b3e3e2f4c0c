// SPDX-License-Identifier: GPL-3.0-or-later
// The pairs by which the texts to the pilot are packed, code 0x80 and on.
// Made by toolchain/texts/main.mjs.
#pragma once
#include "core/packed_text.hpp"

namespace firmware {
namespace notify {

// Only for the compiler: what is read in flight lies in flash.
// clang-format off
constexpr core::CodePair kTextPairs[] = {
    {':', ' '}, {'r', 'e'}, {'s', ' '}, {'e', 'd'}, {'t', ' '}, {'e', ' '}, {'o', 'n'},
    {'n', 'o'}, {'t', 'e'}, {'a', 'r'}, {'i', 0x86}, {'s', 't'}, {'y', ' '}, {'a', 'n'},
    {'i', 'n'}, {'i', 's'}, {'u', 's'}, {'m', 'e'}, {'#', ' '}, {'r', ' '}, {'r', 'm'},
    {0x90, 0x83}, {'A', 0x94}, {'f', 0x95}, {'l', 'o'}, {0x81, 0x97}, {0x87, 0x84}, {'a', 'l'},
    {'s', 0x8A}, {0x8F, 0x9C}, {'P', 0x81}, {'o', ' '}, {0x96, 0x80}, {0x9E, 0xA0}, {'e', 'n'},
    {'t', 'h'}, {'a', 's'}, {'a', 't'}, {' ', 'b'}, {'m', ' '}, {0x99, 0x80}, {'a', 0x91},
    {'r', 'o'}, {'M', 0x9D}, {0x88, 0xA7}, {'a', 'd'}, {0x8E, 'g'}, {' ', 'i'}, {'a', 'c'},
    {'o', 0x81}, {0x87, ' '}, {0x89, 0xA9}, {0xB3, 0x88}, {' ', 'a'}, {' ', 'p'}, {'o', 'm'},
    {'u', 'n'}, {'k', 'e'}, {0xA2, 'c'}, {0xAC, 0x92}, {'v', 'e'}, {'o', 'r'}, {'o', 'u'},
    {0x98, 0x8B}, {0xAB, 0x80}, {'b', 'r'}, {'d', 'e'}, {'i', 0xC1}, {0x8A, ' '}, {0x8B, 0xB1},
    {0x8D, 'd'}, {0x9B, 0xC3}, {0xC7, 0xA5}, {'F', 0xBA}, {'I', 0xBB}, {'e', 'r'}, {'f', 'i'},
    {'s', 'e'}, {0x8D, 0x8C}, {0xB4, 0x93}, {0xC5, 'd'}, {'C', 0xC8}, {'G', 'P'}, {'N', 0x9F},
    {'U', 'T'}, {'a', 0x82}, {'c', 'l'}, {'f', 'a'}, {'h', 'i'}, {'i', 0x82}, {'s', 'i'},
    {'t', 0x82}, {'t', 0x83}, {0xA3, 0x85}, {0xCA, 0xA8}, {0xD1, 0xC4}, {0xD2, 'S'}, {',', ' '},
    {'a', 'g'}, {'c', 0xB7}, {'d', 0x85}, {'l', 'e'}, {'o', 0x8E}, {0x81, 0xAD}, {0xA6, 0x8C},
    {0xAE, ' '}, {'A', 0xD4}, {'E', 'E'}, {'L', 'E'}, {'O', 'M'}, {'P', 'R'}, {'P', 'l'},
    {'i', 'l'}, {'l', 0x8C}, {'m', 0x9D}, {'p', 0xA4}, {'r', 's'}, {'u', 'l'}, {0x89, 0xDC},
    {0xB0, 'k'}, {0xB5, 0x84}, {0xB9, 'y'}, {0xBE, 't'}, {0xC9, 0x85}, {0xEA, 'O'},
    {0xEB, 0xEE}, {0xFD, 0xED}, {'M', 'e'},
};
// clang-format on

}  // namespace notify
}  // namespace firmware
