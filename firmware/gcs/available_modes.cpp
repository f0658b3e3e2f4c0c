// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/available_modes.hpp"

#include <string.h>

#include "core/rom.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/gcs/messages.hpp"
#include "firmware/state/mode_traits.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace gcs {

using namespace state;

namespace {

using Standard = mavlink::MavStandardMode;

struct ModeRow {
    Mode mode;
    uint8_t standard;
    char name[sizeof "INITIALISING"];  // packed they would hardly be shorter
};

// LOITER is no orbit: of those QGroundControl offers none among the modes to choose.
// clang-format off
constexpr ModeRow kModes[] ROM = {
    {Mode::manual,       Standard::non_standard,  "MANUAL"},
    {Mode::circle,       Standard::non_standard,  "CIRCLE"},
    {Mode::stabilize,    Standard::non_standard,  "STABILIZE"},
    {Mode::training,     Standard::non_standard,  "TRAINING"},
    {Mode::acro,         Standard::non_standard,  "ACRO"},
    {Mode::fbwa,         Standard::non_standard,  "FBWA"},
    {Mode::fbwb,         Standard::altitude_hold, "FBWB"},
    {Mode::cruise,       Standard::cruise,        "CRUISE"},
    {Mode::autotune,     Standard::non_standard,  "AUTOTUNE"},
    {Mode::automatic,    Standard::mission,       "AUTO"},
    {Mode::rtl,          Standard::safe_recovery, "RTL"},
    {Mode::loiter,       Standard::non_standard,  "LOITER"},
    {Mode::takeoff,      Standard::takeoff,       "TAKEOFF"},
    {Mode::guided,       Standard::non_standard,  "GUIDED"},
    {Mode::initialising, Standard::non_standard,  "INITIALISING"},
};
// clang-format on
constexpr uint8_t kCount = core::count(kModes);
constexpr uint16_t kMessage = mavlink::Wire<mavlink::AvailableModes>::id;

uint8_t standardOf(Mode mode) {
    for (const ModeRow& row : kModes)
        if (core::romRead(row.mode) == mode) return core::romRead(row.standard);
    return Standard::non_standard;
}

uint8_t propertiesOf(Mode mode) {
    using Property = mavlink::MavModeProperty;
    if (!isMode(static_cast<uint8_t>(mode))) return Property::not_user_selectable;
    return fliesAlone(mode) ? Property::auto_mode : 0;
}

}  // namespace

bool askForModes(Link& link, uint16_t index) {
    if (index > kCount) return false;
    link.modes.next = static_cast<uint8_t>(index == 0 ? 1 : index);
    link.modes.last = static_cast<uint8_t>(index == 0 ? kCount : index);
    requestOnce(link, kMessage);
    return true;
}

void sendAvailableModes() {
    for (Link& link : links) {
        AskedModes& modes = link.modes;
        if (modes.next == 0 || isDue(link, kMessage)) continue;
        modes.next = modes.next == modes.last ? 0 : static_cast<uint8_t>(modes.next + 1);
        if (modes.next != 0) requestOnce(link, kMessage);
    }
}

uint8_t customModeOf(uint16_t standard_mode) {
    for (const ModeRow& row : kModes)
        if (standard_mode != Standard::non_standard && core::romRead(row.standard) == standard_mode)
            return static_cast<uint8_t>(core::romRead(row.mode));
    return kNoCustomMode;
}

bool fillIn(const Link& link, mavlink::AvailableModes& to) {
    if (link.modes.next == 0) return false;
    const ModeRow row = core::romRead(kModes[link.modes.next - 1]);
    to.number_modes = kCount;
    to.mode_index = link.modes.next;
    to.standard_mode = row.standard;
    to.custom_mode = static_cast<uint8_t>(row.mode);
    to.properties = propertiesOf(row.mode);
    memcpy(to.mode_name, row.name, sizeof row.name);
    return true;
}

bool fillIn(const Link&, mavlink::CurrentMode& to) {
    to.standard_mode = standardOf(vehicle.mode);
    to.custom_mode = to.intended_custom_mode = static_cast<uint8_t>(vehicle.mode);
    return true;
}

}  // namespace gcs
}  // namespace firmware
