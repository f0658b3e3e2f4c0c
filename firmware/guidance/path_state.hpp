// SPDX-License-Identifier: GPL-3.0-or-later
// Between the files of this folder only: the path that is flown, and how far.
#pragma once
#include "firmware/state/published.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<PathDemand> : Writable<PathDemand> {
    using Writable::state;
};
template <>
struct Publisher<PathProgress> : Writable<PathProgress> {
    using Writable::state;
};
}  // namespace state

namespace guidance {

static constexpr state::PathDemand& path_demand = state::Publisher<state::PathDemand>::state();
static constexpr state::PathProgress& progress = state::Publisher<state::PathProgress>::state();

}  // namespace guidance
}  // namespace firmware
