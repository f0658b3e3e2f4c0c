// SPDX-License-Identifier: GPL-3.0-or-later
// Cuts a scenario down to the least that still fails: events and items of the mission are left out,
// halves of them first, the air becomes calm and the time short.
#pragma once
#include <functional>

#include "simulator/chaos/scenario.hpp"

namespace simulator::chaos {

using Fails = std::function<bool(const Scenario&)>;

// At most `most_tries` scenarios are tried. `scenario` fails.
Scenario shrink(Scenario scenario, const Fails& fails, unsigned most_tries);

}  // namespace simulator::chaos
