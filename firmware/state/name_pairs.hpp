// SPDX-License-Identifier: GPL-3.0-or-later
// The pairs by which the parameters' names are packed, code 0x80 and on.
// Made by toolchain/texts/main.mjs.
#pragma once
#include "core/packed_text.hpp"

namespace firmware {
namespace state {

// Only for the compiler: what is read in flight lies in flash.
// clang-format off
constexpr core::CodePair kNamePairs[] = {
    {'R', 'C'}, {'S', '_'}, {'_', 'M'}, {'I', 'N'}, {'S', 'R'}, {'_', 'R'}, {'C', 'H'},
    {'A', 'L'}, {'I', 'M'}, {'_', 'T'}, {'T', 'E'}, {'A', 'X'}, {'2', 0x84}, {'L', 'A'},
    {'O', 'N'}, {'_', 'D'}, {'_', 'P'}, {'_', 'S'}, {0x8C, 'V'}, {'H', 'R'}, {'T', 0x86},
    {'D', 'E'}, {0x82, 0x83}, {'A', 'C'}, {'M', 'P'}, {'O', 'F'}, {0x82, 0x8B}, {'E', 'N'},
    {'E', 'V'}, {'C', 0x81}, {'L', 'L'}, {'R', 0x88}, {'T', '_'}, {'_', 'F'}, {'T', 'I'},
    {0x8A, 0x9D}, {0x99, 'F'}, {'A', 'R'}, {'E', 'R'}, {'L', 'T'}, {'A', 'S'}, {'B', 'A'},
    {'P', 'D'}, {'R', 'A'}, {'C', 'O'}, {'E', 'X'}, {'I', 0x94}, {'O', 0x95}, {'P', 0x94},
    {'S', 0xAA}, {'T', 0x93}, {'U', 'T'}, {0x85, 0x9C}, {0x98, 0xA8}, {0xA2, 0x8E},
    {0xAC, 0xB5}, {0xB7, 0x81}, {'A', 'W'}, {'L', 'E'}, {'S', 'T'}, {'_', 0x86}, {'_', 0xAD},
    {0x83, 'G'}, {0x89, 0x9F}, {0x8F, 'Z'}, {0x90, 0xAE}, {0x97, 'C'}, {0xB0, 0x92},
    {0xBD, 'T'}, {'C', 'E'}, {'F', 0x9B}, {'F', 0xA7}, {'K', 0xA4}, {'M', 0xAF}, {'N', 'D'},
    {'O', 'T'}, {'P', 'E'}, {'P', '_'}, {'R', 0x9E}, {'S', 'I'}, {'T', 0xC8}, {0x84, '0'},
    {0x84, '1'}, {0x89, 0x93}, {0x8D, 0xCA}, {0xA9, 'T'}, {0xC6, 0xC5}, {0xC7, 0xC9},
    {'A', 0x98}, {'E', 'L'}, {'F', 0x81}, {'F', 0x8D}, {'L', 'O'}, {'L', 0x88}, {'M', 'A'},
    {'Y', 0xB9}, {'_', 'C'}, {0x80, '5'}, {0x80, '6'}, {0x80, '7'}, {0x80, '8'}, {0x81, 0xC2},
    {0x83, 0xE5}, {0x85, 'A'}, {0xA5, 0xB1}, {0xC4, 0xAB}, {0xCE, 0x92}, {'A', 'B'}, {'A', 'N'},
    {'B', 'W'}, {'C', 'A'}, {'M', 'I'}, {'T', 0x9F}, {'U', 'D'}, {'U', 'N'}, {'V', 'O'},
    {0x80, '1'}, {0x80, '2'}, {0x80, '3'}, {0x80, '4'}, {0x87, 'T'}, {0xA6, 'I'}, {0xD5, 0xA0},
    {0xDB, 0xCD}, {0xDF, 0x92}, {'A', 0xB3}, {'C', 0x87}, {'C', 0xB6},
};
// clang-format on

}  // namespace state
}  // namespace firmware
