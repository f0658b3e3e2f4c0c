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

struct Order {
    bool ordered;
    Mode ordered_in;
};
core::FileState<Order> order{};

bool wanted() {
    if (order.ordered_in != vehicle.mode) order.ordered = false;
    return order.ordered || switchIsUp(parameters.inverted_channel);
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

void orderInverted(bool on) {
    order.ordered = on;
    order.ordered_in = vehicle.mode;
}

void runInverted() { published.inverted = wanted() && possible(); }

}  // namespace control
}  // namespace firmware
