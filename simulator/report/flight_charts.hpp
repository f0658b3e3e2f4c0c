// SPDX-License-Identifier: GPL-3.0-or-later
// The charts of a flight report. A chart without data is an empty string.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "simulator/ground/plan.hpp"
#include "simulator/report/chart.hpp"
#include "simulator/report/recorder.hpp"
#include "simulator/report/summary.hpp"

namespace simulator {

class FlightCharts {
public:
    FlightCharts(const Summary& summary, const std::vector<Sample>& samples, const Plan& plan);

    std::string map() const;
    std::string altitude() const;
    std::string airspeed() const;
    std::string crosstrack() const;
    std::string roll() const;
    std::string pitch() const;
    std::string surfaces() const;
    std::string otherServos() const;
    std::string frames() const;

private:
    using Value = std::function<std::optional<double>(const Sample&)>;
    Points series(const Value& value) const;
    std::string attitude(const char* label, const Value& truth, const Value& demand) const;
    Chart overTime(const std::string& y_label, bool items = true) const;

    std::string servos(const std::vector<size_t>& outputs, const char* label) const;
    double radius_m(const PlannedNav& nav) const;  // of its circle, 0: none known
    Points legs() const;
    Points circles() const;

    const Summary& summary_;
    std::vector<Sample> flight_;  // from shortly before AUTO on
    const Plan& plan_;
};

}  // namespace simulator
