// SPDX-License-Identifier: GPL-3.0-or-later
// Where a flight of the fly program comes from, by its command line.
#pragma once
#include "simulator/fly_options.hpp"
#include "simulator/parameter_file.hpp"
#include "simulator/report/summary.hpp"

namespace simulator {

Provenance provenanceOf(const FlyOptions& options, const ParameterSettings& settings);
std::vector<FaultSpan> faultSpans(const std::vector<Fault>& faults);
std::vector<std::string> faultTexts(const std::vector<Fault>& faults);  // as on the command line

// The settings a flight began with and those that ground stations have set in it (MAVLink's are
// floats: of 0.46 the nearest).
std::map<std::string, double> parametersOf(const ParameterSettings& settings,
                                           const std::map<std::string, double>& set);

}  // namespace simulator
