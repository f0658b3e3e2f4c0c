// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/flight_table.hpp"

#include <algorithm>
#include <cmath>

#include "toolchain/mission_tool/columns.hpp"

namespace mission_tool {
namespace {

constexpr size_t kMaxRows = 200;

Cells rowOf(const Document& document, const Visit& visit, const Stretch* stretch) {
    if (visit.nav == 0)
        return {"", "(circles)", "", "", "", "", "", "", besideOf(document, visit)};
    Cells row = {std::to_string(visit.nav), nameOf(document.entries[visit.nav])};
    if (stretch == nullptr) {
        row.resize(8);
    } else if (stretch->ground_mps <= 0) {
        for (const char* cell : {"never", "", "", "", "", ""}) row.push_back(cell);
    } else {
        row.push_back(format("%.0f m", stretch->length_m));
        row.push_back(format("%.1f m/s", stretch->ground_mps));
        row.push_back(format("%+.1f m/s", stretch->needed_climb_mps));
        row.push_back(format("%.0f m", stretch->height_m));
        row.push_back(minutesAndSeconds(stretch->time_s));
        row.push_back(format("%.0f mAh", stretch->used_mah));
    }
    row.push_back(besideOf(document, visit));
    return row;
}

}  // namespace

std::string besideOf(const Document& document, const Visit& visit) {
    constexpr size_t kMaxNamed = 12;
    std::string text;
    for (size_t i = 0; i < std::min(visit.beside.size(), kMaxNamed); ++i)
        text += (i == 0 ? "" : ", ") + std::to_string(visit.beside[i]) + ' ' +
                nameOf(document.entries[visit.beside[i]]);
    if (visit.beside.size() > kMaxNamed)
        text += " and " + std::to_string(visit.beside.size() - kMaxNamed) + " more";
    return text;
}

std::string windInWords(const Wind& wind) {
    if (wind.speed_mps == 0) return "calm air";
    if (!wind.from_deg) return format("%.1f m/s against every leg", wind.speed_mps);
    return format("%.1f m/s from %03.0f", wind.speed_mps, *wind.from_deg);
}

std::string sumsOf(const FlightOrder& order, const Estimate& estimate) {
    const double percent =
        estimate.capacity_mah > 0 ? 100 * estimate.used_mah / estimate.capacity_mah : 0;
    std::string text;
    text += format("%.2f km in %s min, %.0f mAh of %.0f (%.0f %%)\n", estimate.length_m / 1000,
                   minutesAndSeconds(estimate.time_s).c_str(), estimate.used_mah,
                   estimate.capacity_mah, percent);
    text += format("climbs %.0f m in all, %.0f m above home at most, %.0f m from home at most\n",
                   estimate.climbed_m, estimate.highest_m, estimate.farthest_m);
    const bool never = std::any_of(estimate.stretches.begin(), estimate.stretches.end(),
                                   [](const Stretch& s) { return s.ground_mps <= 0; });
    if (never) text += "a leg is never flown against this wind: it is left out of the sums\n";
    if (order.end != FlightOrder::End::landed) text += "the mission " + endOf(order) + "\n";
    return text;
}

std::string flightTableOf(const Document& document, const FlightOrder& order,
                          const Estimate& estimate) {
    std::vector<Cells> lines = {{"NAV", "", "way", "ground", "climb", "height", "time", "battery",
                                 "beside it, as they begin"}};
    size_t next = 0;
    for (size_t i = 0; i < std::min(order.visits.size(), kMaxRows); ++i) {
        const Visit& visit = order.visits[i];
        const bool reckoned = visit.nav != 0 && next < estimate.stretches.size();
        lines.push_back(
            rowOf(document, visit, reckoned ? &estimate.stretches[next++] : nullptr));
    }
    std::string text = inColumns(lines, {true, false, true, true, true, true, true, true, false});
    if (order.visits.size() > kMaxRows)
        text += "and " + std::to_string(order.visits.size() - kMaxRows) + " more\n";
    return text;
}

}  // namespace mission_tool
