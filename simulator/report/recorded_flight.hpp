// SPDX-License-Identifier: GPL-3.0-or-later
// The document of a simulated flight, from what was recorded of it.
#pragma once
#include <vector>

#include "simulator/ground/mission_file.hpp"
#include "simulator/report/flight_document.hpp"
#include "simulator/report/recorder.hpp"
#include "simulator/report/summary.hpp"

namespace simulator {

FlightDocument documentOf(const Summary& summary, const std::vector<Sample>& samples,
                          const MissionFile& mission);

// `loiter_radius_m`: of circles that name none.
DocumentPlan planOf(const MissionFile& mission, std::optional<double> loiter_radius_m);

// What begins and ends by status texts, the open ones at `end_s`.
std::vector<DocumentBand> failsafeBands(const std::vector<Event>& texts, double end_s);

}  // namespace simulator
