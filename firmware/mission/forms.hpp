// SPDX-License-Identifier: GPL-3.0-or-later
// How each form of APM 2.0 command stands in an item: a row a form.
#pragma once
#include <math.h>

#include "core/seldom.hpp"
#include "firmware/mission/item.hpp"

namespace firmware {
namespace mission {

constexpr MissionResult kFine = MissionResult::accepted;
constexpr MissionResult wrong(uint8_t parameter) {
    return static_cast<MissionResult>(static_cast<uint8_t>(MissionResult::invalid_param1) - 1 +
                                      parameter);
}

enum Part : uint8_t {
    kAltitude = 1,
    kPlace = 2 + kAltitude,
    kDirection = 4,          // the sign of param3, which is the radius of a loiter
    kDirectionInTwo = 8,     // ... of param2
    kNumberInAltitude = 16,  // p1 is z
};

// For fields that need more than rounding. parameter[1] .. parameter[4]; unset ones are NaN.
using EncodeSpecial = MissionResult (*)(const float* parameter, ::mission::Record&,
                                        EncodeWarnings&);
using DecodeSpecial = void (*)(const ::mission::Record&, float* parameter);

struct FormRow {
    uint8_t from[4];  // which of param1..4 is p1 .. p4; 0: none, or the special has it
    uint8_t parts;
    uint8_t special_uses;  // a bit a parameter
    EncodeSpecial encode;
    DecodeSpecial decode;
};

constexpr uint8_t use(uint8_t parameter) { return static_cast<uint8_t>(1u << parameter); }

SELDOM inline float orZero(float value) { return isnan(value) ? 0 : value; }

inline void flagRounding(float value, float stored, EncodeWarnings& warnings) {
    if (value != stored) warnings.rounded = true;
}

FormRow formRow(uint8_t form);

}  // namespace mission
}  // namespace firmware
