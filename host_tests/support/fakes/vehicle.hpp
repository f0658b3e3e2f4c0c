// SPDX-License-Identifier: GPL-3.0-or-later
// The tests' way to write what the firmware's rooms publish.
#pragma once
#include "firmware/state/published.hpp"

namespace firmware {
namespace state {

template <>
struct Publisher<Vehicle> : Writable<Vehicle> {
    using Writable::state;
};

static constexpr Vehicle& mutable_vehicle = Publisher<Vehicle>::state();

}  // namespace state
}  // namespace firmware
