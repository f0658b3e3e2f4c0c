// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/chaos/totals.hpp"

#include <cstdio>
#include <set>

namespace simulator::chaos {
namespace {

// A sag's depth is another one each time: supply:sag_3.75v.
std::string withoutNumber(const std::string& what) {
    const size_t digit = what.find_first_of("0123456789");
    return what.substr(0, digit == std::string::npos ? digit : what.rfind('_', digit));
}

void take(Drawn& drawn, unsigned times, const Outcome& outcome) {
    drawn.times += times;
    ++drawn.flights;
    drawn.crashed += outcome.crashed;
    drawn.violated += !outcome.violations.empty();
}

}  // namespace

std::map<std::string, unsigned> eventsIn(const Scenario& scenario) {
    std::map<std::string, unsigned> events;
    for (const Event& event : scenario.events) {
        const bool of_a_kind = event.kind() == "fault" || event.kind() == "restart";
        ++events[of_a_kind ? event.kind() + " " + withoutNumber(event.words[1]) : event.kind()];
    }
    return events;
}

void Totals::add(const Scenario& scenario, const Outcome& outcome) {
    ++flights_;
    airborne_ += outcome.airborne;
    crashed_ += outcome.crashed;
    promised_ += promisesToSurvive(scenario);
    violated_ += !outcome.violations.empty();
    emulated_s_ += outcome.emulated_s;
    take(airplanes_[scenario.airplane], 1, outcome);
    for (const auto& [name, times] : eventsIn(scenario)) take(events_[name], times, outcome);
    std::set<std::string> names;
    for (const auto& each : outcome.violations) names.insert(each.name);
    for (const auto& name : names) ++violations_[name];
}

std::string Totals::text() const {
    char line[160];
    std::snprintf(line, sizeof line,
                  "%u flights, %u airborne, %u crashed, %u that must not; %.1f emulated hours\n",
                  flights_, airborne_, crashed_, promised_, emulated_s_ / 3600);
    std::string all = line;
    for (const auto& [name, drawn] : events_) {
        std::snprintf(line, sizeof line, "%8u  %s\n", drawn.times, name.c_str());
        all += line;
    }
    all += violations_.empty() ? "nothing was violated\n" : "flights that violated\n";
    for (const auto& [name, count] : violations_) {
        std::snprintf(line, sizeof line, "%8u  %s\n", count, name.c_str());
        all += line;
    }
    return all;
}

}  // namespace simulator::chaos
