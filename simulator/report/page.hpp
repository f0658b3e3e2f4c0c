// SPDX-License-Identifier: GPL-3.0-or-later
// report.html: one file that opens offline.
#pragma once
#include <string>
#include <vector>

#include "simulator/ground/plan.hpp"
#include "simulator/report/recorder.hpp"
#include "simulator/report/summary.hpp"

namespace simulator {

std::string reportPage(const Summary& summary, const std::vector<Sample>& samples,
                       const Plan& plan);

}  // namespace simulator
