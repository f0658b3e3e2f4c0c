// SPDX-License-Identifier: GPL-3.0-or-later
// The series of a simulated flight: what each is called and which value of a sample it is.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "simulator/report/flight_document.hpp"
#include "simulator/report/recorder.hpp"

namespace simulator {

struct RecordedSeries {
    std::string name, title;
    const char *unit, *group, *kind;  // kind: truth, estimate, demand, measured, ""
    bool slow;                        // changes so slowly that every fifth sample says it all
    std::function<std::optional<double>(const Sample&)> value;
};

const std::vector<RecordedSeries>& recordedSeries();

// Into the document's times and series; a series without a single value is left out.
void addSeries(FlightDocument& document, const std::vector<Sample>& samples);

}  // namespace simulator
