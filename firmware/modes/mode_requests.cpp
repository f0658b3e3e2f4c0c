// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/modes/mode_requests.hpp"

#include "core/rom.hpp"
#include "firmware/state/causes.hpp"
#include "firmware/state/mode_traits.hpp"

namespace firmware {
namespace modes {

using namespace state;

namespace {

enum class Granted : uint8_t {
    none,
    manual,          // MANUAL alone: it needs no attitude
    without_sticks,  // what flies without the pilot's sticks
    any,
};

struct RequestRow {
    Granted resuming, no_attitude, no_sticks;
};

// In the order of ModeReason.
// clang-format off
constexpr RequestRow kRequests[] ROM = {
    // resuming      no attitude      no sticks
    {Granted::any,  Granted::any,    Granted::any},             // restart
    {Granted::none, Granted::any,    Granted::any},             // failsafe
    {Granted::none, Granted::any,    Granted::any},             // boot
    {Granted::none, Granted::manual, Granted::without_sticks},  // pilot
    {Granted::none, Granted::manual, Granted::without_sticks},  // ground
    {Granted::none, Granted::manual, Granted::without_sticks},  // mission
};
// clang-format on

bool includes(Granted granted, Mode mode) {
    if (granted == Granted::manual) return mode == Mode::manual;
    if (granted == Granted::without_sticks) return fliesAlone(mode);
    return granted == Granted::any;
}

}  // namespace

ModeSituation modeSituation() {
    return {vehicle.resuming, failing(Cause::inertial),
            failing(Cause::radio_short) || failing(Cause::radio_long)};
}

bool mayEnter(Mode mode, ModeReason reason, const ModeSituation& now) {
    const RequestRow row = core::romRead(kRequests[static_cast<uint8_t>(reason)]);
    return (!now.resuming || includes(row.resuming, mode)) &&
           (!now.no_attitude || includes(row.no_attitude, mode)) &&
           (!now.no_sticks || includes(row.no_sticks, mode));
}

}  // namespace modes
}  // namespace firmware
