// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/state/mode_traits.hpp"

#include "core/rom.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace state {
namespace {

enum Trait : uint8_t { kMode = 1, kGuides = 2, kAutoThrottle = 4, kStickSetsSpeed = 8 };
constexpr uint8_t kAlone = kMode | kGuides | kAutoThrottle;
constexpr uint8_t kAssisted = kAlone | kStickSetsSpeed;

// By the mode's number.
// clang-format off
constexpr uint8_t kTraits[] ROM = {
    kMode,      //  0 MANUAL
    kAlone,     //  1 CIRCLE
    kMode,      //  2 STABILIZE
    kMode,      //  3 TRAINING
    kMode,      //  4 ACRO
    kMode,      //  5 FBWA
    kAssisted,  //  6 FBWB
    kAssisted,  //  7 CRUISE
    kMode,      //  8 AUTOTUNE
    0,
    kAlone,     // 10 AUTO
    kAlone,     // 11 RTL
    kAlone,     // 12 LOITER
    kAlone,     // 13 TAKEOFF
    0,
    kAlone,     // 15 GUIDED
    0,          // 16 initialising
};
// clang-format on

uint8_t traitsOf(uint8_t mode) {
    return mode < core::count(kTraits) ? core::romRead(kTraits[mode]) : 0;
}
bool has(Trait trait) { return (traitsOf(static_cast<uint8_t>(vehicle.mode)) & trait) != 0; }

}  // namespace

bool isMode(uint8_t custom_mode) { return traitsOf(custom_mode) != 0; }
bool fliesAlone(Mode mode) { return (traitsOf(static_cast<uint8_t>(mode)) & kAssisted) == kAlone; }
bool guidesItself() { return has(kGuides); }
bool autoThrottle() { return has(kAutoThrottle); }
bool stickSetsSpeed() { return has(kStickSetsSpeed); }

}  // namespace state
}  // namespace firmware
