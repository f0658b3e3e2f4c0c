// SPDX-License-Identifier: GPL-3.0-or-later
// The flown track for other programs: KML with its times (gx:Track) and the mission's places as
// pins, for Google Earth; GPX for maps and everything else.
#pragma once
#include <string>
#include <vector>

#include "simulator/report/flight_document.hpp"
#include "simulator/report/recorder.hpp"

namespace simulator {

// Times are seconds since power-on from `epoch_s`, Unix time: a format without a date is none.
std::string trackKml(const std::vector<Sample>& samples, const DocumentPlan& plan,
                     const std::string& name, int64_t epoch_s);
std::string trackGpx(const std::vector<Sample>& samples, const DocumentPlan& plan,
                     const std::string& name, int64_t epoch_s);

// Of every simulated flight: when its GPS says that it began.
constexpr int64_t kSimulatedEpoch_s = 1'717'408'800;  // as simulator/devices/gps_fix.hpp

}  // namespace simulator
