// SPDX-License-Identifier: GPL-3.0-or-later
// A flight in figures, with the goals and limits that there are; and what the board did, as tables.
#pragma once
#include <vector>

#include "simulator/report/flight_document.hpp"
#include "simulator/report/summary.hpp"

namespace simulator {

std::vector<Deviation> deviationsOf(const Summary& summary);  // those that are known
std::vector<DocumentTable> tablesOf(const Summary& summary);

}  // namespace simulator
