// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/log_tool/report.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "simulator/ground/plan.hpp"
#include "simulator/ground/telemetry.hpp"
#include "simulator/report/page.hpp"
#include "simulator/report/recorder.hpp"
#include "simulator/report/summary.hpp"
#include "toolchain/log_tool/names.hpp"

namespace log_tool {
namespace {

using simulator::Sample;

constexpr double kRadians = M_PI / 180;
constexpr double kLiftOff_m = 3;
enum EventId { kArmed = 10, kDisarmed = 11, kOnTheGround = 18, kInTheAir = 28 };

double seconds(const Record& record) { return record["TimeUS"] * 1e-6; }

// As it was when the log began; a command that begins is the same item again.
simulator::Waypoints missionOf(const LogFile& log) {
    std::map<int, simulator::WaypointItem> items;
    for (const Record* cmd : log.named("CMD")) {
        simulator::WaypointItem item;
        item.index = static_cast<int>((*cmd)["CNum"]);
        item.command = static_cast<uint16_t>((*cmd)["CId"]);
        item.frame = static_cast<uint8_t>((*cmd)["Frame"]);
        item.params = {(*cmd)["Prm1"], (*cmd)["Prm2"], (*cmd)["Prm3"], (*cmd)["Prm4"]};
        item.latitude_deg = (*cmd)["Lat"];
        item.longitude_deg = (*cmd)["Lng"];
        item.altitude_m = (*cmd)["Alt"];
        items.emplace(item.index, item);
    }
    simulator::Waypoints mission;
    for (const auto& [index, item] : items) mission.push_back(item);
    return mission;
}

double parameter(const LogFile& log, const std::string& name) {
    double value = NAN;
    for (const Record* parm : log.named("PARM"))
        if (parm->text("Name") == name) value = (*parm)["Value"];
    return value;
}

// What the records up to now say, sampled whenever there is an attitude.
class Playback {
public:
    Playback(const LogFile& log, const simulator::Plan& plan, const simulator::LocalFrame& frame)
        : frame_(frame), metrics(plan, {}) {
        const double cruise_cms = parameter(log, "TRIM_ARSPD_CM");
        if (std::isfinite(cruise_cms)) metrics.setCruiseSpeed(cruise_cms / 100);
        now_.mode = -1;
        for (const Record& record : log.records()) take(record, plan);
    }

    std::vector<Sample> samples;

private:
    void take(const Record& record, const simulator::Plan& plan) {
        const std::string& name = record.kind->name;
        if (name == "ATT") sample(record);
        if (name == "CTUN") takeControl(record);
        if (name == "NTUN") takePlace(record);
        if (name == "MODE") now_.mode = static_cast<int>(record["ModeNum"]);
        if (name == "EV" && record["Id"] == kArmed) now_.armed = true;
        if (name == "EV" && record["Id"] == kDisarmed) now_.armed = false;
        if (name == "RCOU")
            for (size_t i = 0; i < 8; ++i) now_.servo_us[i] = record["Ch" + std::to_string(i + 1)];
        if (name == "MSG" && record.text("Message").rfind("Mission item ", 0) == 0) {
            const int item = std::atoi(record.text("Message").c_str() + 13);
            if (plan.nav(item) != nullptr) item_ = item;
        }
    }
    void takeControl(const Record& record) {
        now_.truth.height_m = record["Alt"];
        now_.truth.equivalent_airspeed_mps = record["Aspd"];
        now_.roll_demand_deg = record["NavRoll"];
        now_.pitch_demand_deg = record["NavPitch"];
    }
    void takePlace(const Record& record) {
        now_.truth.latitude_deg = record["Lat"];
        now_.truth.longitude_deg = record["Lng"];
        now_.place = frame_.at(record["Lat"], record["Lng"]);
        now_.truth.north_m = now_.place.north_m;
        now_.truth.east_m = now_.place.east_m;
        now_.distance_m = record["WpDist"];
        placed_ = true;
    }
    void sample(const Record& record) {
        if (!placed_) return;
        now_.time_s = seconds(record);
        now_.truth.time_us = static_cast<uint64_t>(record["TimeUS"]);
        now_.truth.roll_rad = record["Roll"] * kRadians;
        now_.truth.pitch_rad = record["Pitch"] * kRadians;
        now_.truth.yaw_rad = record["Yaw"] * kRadians;
        now_.truth.on_ground = now_.truth.height_m < kLiftOff_m;
        now_.item = now_.mode == static_cast<int>(simulator::kModeAuto) ? item_ : 0;
        now_.planned = metrics.sample(now_.time_s, now_.truth, now_.place, now_.item);
        samples.push_back(now_);
    }

    const simulator::LocalFrame frame_;
    Sample now_{};
    int item_ = 0;
    bool placed_ = false;

public:
    simulator::Metrics metrics;
};

void reportEvents(const LogFile& log, simulator::Summary& summary) {
    const Firmware firmware = firmwareOf(log);
    double up_s = NAN;
    for (const Record& record : log.records()) {
        const std::string& name = record.kind->name;
        if (name == "MODE")
            summary.events.push_back(
                {seconds(record),
                 "mode " + simulator::modeName(static_cast<uint32_t>(record["ModeNum"]))});
        if (name == "MSG") summary.texts.push_back({seconds(record), record.text("Message")});
        if (name == "ERR")
            summary.events.push_back({seconds(record), "error " + meaningOf(record, firmware)});
        if (name != "EV") continue;
        const int id = static_cast<int>(record["Id"]);
        summary.events.push_back({seconds(record), eventName(id)});
        if (id == kInTheAir) up_s = seconds(record);
        if (id == kOnTheGround) summary.flight_time_s = seconds(record) - up_s;
        if (id == kDisarmed) summary.completed = std::isfinite(up_s);
    }
}

}  // namespace

std::string report(const LogFile& log, const std::string& name) {
    const simulator::Waypoints mission = missionOf(log);
    const auto places = log.named("NTUN");
    const bool has_home = !mission.empty() && mission[0].latitude_deg != 0;
    const double latitude_deg = has_home         ? mission[0].latitude_deg
                                : places.empty() ? 0
                                                 : (*places[0])["Lat"];
    const double longitude_deg = has_home         ? mission[0].longitude_deg
                                 : places.empty() ? 0
                                                  : (*places[0])["Lng"];
    const simulator::LocalFrame frame(latitude_deg, longitude_deg);
    const simulator::Plan plan = makePlan(mission, frame);
    const Playback playback(log, plan, frame);

    simulator::Summary summary;
    summary.from_log = true;
    summary.mission = name;
    const std::string version = banner(log);
    summary.firmware = version.empty() ? "firmware unknown" : version;
    summary.board = "the airplane";
    summary.reason = "the log ends before the airplane was disarmed after a flight";
    for (const simulator::PlannedNav& nav : plan.navs) summary.items_planned.push_back(nav.item);
    summary.crosstrack_rms_m = playback.metrics.crosstrack.rms();
    summary.crosstrack_max_m = playback.metrics.crosstrack.max();
    summary.altitude_rms_m = playback.metrics.altitude.rms();
    summary.altitude_max_m = playback.metrics.altitude.max();
    summary.airspeed_rms_mps = playback.metrics.airspeed.rms();
    const double radius_m = parameter(log, "WP_LOITER_RAD");
    if (std::isfinite(radius_m)) summary.loiter_radius_m = radius_m;
    if (!playback.samples.empty()) summary.emulated_s = playback.samples.back().time_s;
    reportEvents(log, summary);
    return reportPage(summary, playback.samples, plan);
}

}  // namespace log_tool
