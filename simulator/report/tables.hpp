// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of a flight report as HTML; empty strings where nothing is known.
#pragma once
#include <string>

#include "simulator/report/summary.hpp"

namespace simulator {

std::string summaryTable(const Summary& summary);
std::string eventTable(const Summary& summary);
std::string violationTable(const Summary& summary);
std::string taskTable(const Summary& summary);
std::string interruptTable(const BoardFigures& figures, double emulated_s);
std::string errorTable();

}  // namespace simulator
