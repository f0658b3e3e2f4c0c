// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/fly_served.hpp"

#include <algorithm>

#include "simulator/live/held_mission.hpp"
#include "simulator/report/status_line.hpp"

namespace simulator {
namespace {

constexpr int kFramesPerSample = kStepsPerSample * (kStep_us / kFrame_us);

std::string endOfServed(const Truth& truth, const std::string& fault) {
    if (!fault.empty()) return fault;
    if (truth.crashed) return "served flight: crashed";
    return std::string(kServedEnd) + (truth.on_ground ? " on the ground" : " in the air");
}

// Of a flight that never left the ground there is none.
std::optional<double> airborne_s(const std::vector<Sample>& samples) {
    constexpr double kAirborne_m = 2, kSample_s = kFramesPerSample * kFrame_us * 1e-6;
    const auto count = std::count_if(samples.begin(), samples.end(), [](const Sample& each) {
        return !each.truth.on_ground && each.truth.height_m > kAirborne_m;
    });
    if (count == 0) return std::nullopt;
    return static_cast<double>(count) * kSample_s;
}

}  // namespace

ServedRecord::ServedRecord(const FlyOptions& options, const Waypoints& items,
                           const ParameterSettings& settings)
    : options_(options),
      settings_(settings),
      folder_(prepareReport(options)),
      frame_(items[0].latitude_deg, items[0].longitude_deg),
      recorder_(no_plan_, frame_) {}

void ServedRecord::step(WatchedBoard& board, live::Live& live) {
    const Telemetry& telemetry = live.station().telemetry();
    armed_ = armed_ || telemetry.armed();
    recorder_.watchFrame(board, telemetry);
    if (++steps_ % kFramesPerSample != 0) return;
    if (live.station().plans().changes() != plans_) {
        plans_ = live.station().plans().changes();
        plan_since_ = recorder_.samples().size();
    }
    recorder_.sample(board, telemetry, std::nullopt, std::nullopt);
}

// Against the plan that the board holds at the end, since it holds it.
void ServedRecord::measure(Metrics& metrics, std::vector<Sample>& samples,
                           const live::Station& station) const {
    if (const auto cruise_cmps = station.parameter("TRIM_ARSPD_CM"))
        metrics.setCruiseSpeed(*cruise_cmps * 0.01);
    metrics.setLoiterRadius(station.parameter("WP_LOITER_RAD"));
    for (size_t i = plan_since_; i < samples.size(); ++i) {
        Sample& each = samples[i];
        if (!each.armed) metrics.setHomeHeight(each.truth.height_m);
        each.planned = metrics.sample(each.time_s, each.truth, each.place, each.item);
    }
}

void ServedRecord::write(WatchedBoard& board, FlyWatchers& watchers, const std::string& fault,
                         Results& results) {
    const live::Station& station = watchers.live()->station();
    const live::PlanDownload& plans = station.plans();
    const MissionFile held = live::heldMission(plans.items(0), plans.items(1), plans.items(2));
    const Plan plan = held.items.empty() ? Plan{} : makePlan(held.items, frame_);
    std::vector<Sample> samples = recorder_.samples();
    Metrics metrics(plan, std::nullopt);
    measure(metrics, samples, station);
    Summary s = summaryOf(options_, board, recorder_, clock_);
    s.reason = endOfServed(board.world().truth(), fault);
    takeErrors(s, metrics, recorder_.attitude());
    addTelemetry(s, station.telemetry());
    s.loiter_radius_m = station.parameter("WP_LOITER_RAD");
    s.flight_time_s = airborne_s(samples);
    for (const PlannedNav& nav : plan.navs) s.items_planned.push_back(nav.item);
    if (ours(options_)) takeViolations(s, board);
    watchers.end(s.reason, s);
    if (!armed_ && options_.out.empty()) {
        std::cout << "never armed: no report" << std::endl;
        return;
    }
    takeProvenance(s, options_, settings_, board);
    writeReport(options_, *folder_, s, samples, held, results);
    if (results.allWritten()) std::cout << reportLine(folder_->path()) << std::flush;
}

}  // namespace simulator
