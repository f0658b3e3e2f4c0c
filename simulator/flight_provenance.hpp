// SPDX-License-Identifier: GPL-3.0-or-later
// Where a flight of the fly program comes from, by its command line.
#pragma once
#include "simulator/fly_options.hpp"
#include "simulator/parameter_file.hpp"
#include "simulator/report/summary.hpp"

namespace simulator {

Provenance provenanceOf(const FlyOptions& options, const ParameterSettings& settings);
std::vector<FaultSpan> faultSpans(const std::vector<Fault>& faults);

}  // namespace simulator
