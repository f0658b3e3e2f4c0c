// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/control/inverted.hpp"

#include "core/file_state.hpp"
#include "firmware/sensors/radio.hpp"
#include "firmware/state/mode_traits.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/published.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<InvertedState> : Writable<InvertedState> {
    using Writable::state;
};
}  // namespace state

namespace control {

using namespace state;
using namespace sensors;

namespace {

constexpr InvertedState& published = Publisher<InvertedState>::state();

// Half a roll costs height, and so does a wing that was not made for it.
constexpr float kLowestToRoll_m = 30, kLowest_m = 15;

struct InvertedRequest {
    bool ordered;
    Mode ordered_in;
};
core::FileState<InvertedRequest> request{};

bool wanted() {
    if (request.ordered_in != vehicle.mode) request.ordered = false;
    return request.ordered || switchIsUp(parameters.inverted_channel);
}

bool possible() {
    const bool holds_attitude =
        vehicle.sticks == Sticks::nothing || vehicle.sticks == Sticks::on_top;
    const Path path = guidesItself() ? vehicle.demand.path : Path::none;
    const float lowest_m = vehicle.inverted ? kLowest_m : kLowestToRoll_m;
    return vehicle.armed && vehicle.estimate.flying && holds_attitude && path != Path::takeoff &&
           path != Path::land && vehicle.mode != Mode::manual && vehicle.mode != Mode::autotune &&
           vehicle.estimate.height_m > lowest_m;
}

}  // namespace

void requestInverted(bool on) {
    request.ordered = on;
    request.ordered_in = vehicle.mode;
}

void runInverted() { published.inverted = wanted() && possible(); }

}  // namespace control
}  // namespace firmware
