// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/log_tool/log_document.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "simulator/ground/plan.hpp"
#include "simulator/ground/telemetry.hpp"
#include "simulator/report/names.hpp"
#include "simulator/report/recorded_flight.hpp"
#include "simulator/report/recorder.hpp"
#include "simulator/report/summary.hpp"
#include "simulator/report/tables.hpp"
#include "toolchain/log_tool/log_series.hpp"
#include "toolchain/log_tool/names.hpp"

namespace log_tool {
namespace {

using simulator::DocumentBand;
using simulator::DocumentEvent;
using simulator::Sample;

constexpr double kRadians = M_PI / 180;
constexpr double kLiftOff_m = 3;
constexpr char kItem[] = "Mission item ";
enum EventId { kArmed = 10, kDisarmed = 11, kOnTheGround = 18, kInTheAir = 28 };

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
        if (name == "NTUN") now_.distance_m = record["Dist"];
        if (name == "POS") takePlace(record);
        if (name == "MODE") now_.mode = static_cast<int>(record["ModeNum"]);
        if (name == "EV" && record["Id"] == kArmed) now_.armed = true;
        if (name == "EV" && record["Id"] == kDisarmed) now_.armed = false;
        if (name == "RCOU")
            for (size_t i = 0; i < 8; ++i) now_.servo_us[i] = record["C" + std::to_string(i + 1)];
        if (name == "MSG" && record.text("Message").rfind("Mission item ", 0) == 0) {
            const int item = std::atoi(record.text("Message").c_str() + 13);
            if (plan.nav(item) != nullptr) item_ = item;
        }
    }
    void takeControl(const Record& record) {
        now_.truth.equivalent_airspeed_mps = record["As"];
        now_.roll_demand_deg = record["NavRoll"];
        now_.pitch_demand_deg = record["NavPitch"];
    }
    void takePlace(const Record& record) {
        now_.truth.latitude_deg = record["Lat"];
        now_.truth.longitude_deg = record["Lng"];
        now_.place = frame_.at(record["Lat"], record["Lng"]);
        now_.truth.north_m = now_.place.north_m;
        now_.truth.east_m = now_.place.east_m;
        now_.truth.height_m = record["RelHomeAlt"];
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

bool begins(const std::string& text, const std::string& with) { return text.rfind(with, 0) == 0; }

std::string kindOf(const Record& record, const std::string& text) {
    const std::string& name = record.kind->name;
    if (name == "MODE") return "mode";
    if (name == "ERR") return begins(text, "FAILSAFE_") ? "failsafe" : "error";
    if (name == "EV") return record["Id"] == kArmed || record["Id"] == kDisarmed ? "armed" : "text";
    return begins(text, kItem) ? "item" : "text";
}

std::vector<DocumentEvent> eventsOf(const LogFile& log, Firmware firmware) {
    std::vector<DocumentEvent> events;
    for (const Record& record : log.records()) {
        const std::string& name = record.kind->name;
        if (!std::isfinite(seconds(record))) continue;
        if (name != "MODE" && name != "MSG" && name != "EV" && name != "ERR") continue;
        const std::string text = meaningOf(record, firmware);
        events.push_back(
            {seconds(record), kindOf(record, text), name == "MODE" ? "mode " + text : text, {}});
    }
    return events;
}

// Each lasts until the next of its kind and subsystem, the last one to the end.
class Bands {
public:
    explicit Bands(double end_s) : end_s_(end_s) {}

    void take(const Record& record, Firmware firmware) {
        const std::string& name = record.kind->name;
        if (name == "MODE") begin("mode", "mode", meaningOf(record, firmware), seconds(record));
        if (name != "ERR") return;
        const std::string subsystem =
            simulator::logSubsystemName(static_cast<int>(record["Subsys"]));
        if (!begins(subsystem, "FAILSAFE_")) return;
        end(subsystem, seconds(record));
        if (record["ECode"] != 0)
            begin(subsystem, "failsafe", meaningOf(record, firmware), seconds(record));
    }

    std::vector<DocumentBand> all;

private:
    void begin(const std::string& key, const char* kind, const std::string& name, double from_s) {
        end(key, from_s);
        open_[key] = all.size();
        all.push_back({kind, name, from_s, end_s_});
    }
    void end(const std::string& key, double at_s) {
        const auto open = open_.find(key);
        if (open == open_.end()) return;
        all[open->second].to_s = at_s;
        open_.erase(open);
    }

    const double end_s_;
    std::map<std::string, size_t> open_;
};

std::vector<DocumentBand> bandsOf(const LogFile& log, Firmware firmware) {
    double end_s = 0;
    for (const Record& record : log.records())
        if (std::isfinite(seconds(record))) end_s = std::max(end_s, seconds(record));
    Bands bands(end_s);
    for (const Record& record : log.records())
        if (std::isfinite(seconds(record))) bands.take(record, firmware);
    return bands.all;
}

// In seconds; NaN where the airplane was not up, or did not come down.
struct Flown {
    double up_s = NAN, flight_s = NAN;
    bool ended = false;  // disarmed after it
};

Flown flownIn(const LogFile& log) {
    Flown flown;
    for (const Record* event : log.named("EV")) {
        const int id = static_cast<int>((*event)["Id"]);
        if (id == kInTheAir) flown.up_s = seconds(*event);
        if (id == kOnTheGround) flown.flight_s = seconds(*event) - flown.up_s;
        if (id == kDisarmed) flown.ended = std::isfinite(flown.up_s);
    }
    return flown;
}

// Around home, or where the airplane was first.
simulator::LocalFrame frameOf(const LogFile& log, const simulator::Waypoints& mission) {
    if (!mission.empty() && mission[0].isPlaced())
        return {mission[0].latitude_deg, mission[0].longitude_deg};
    const auto places = log.named("POS");
    if (places.empty()) return {0, 0};
    return {(*places[0])["Lat"], (*places[0])["Lng"]};
}

std::vector<simulator::Deviation> deviationsIn(const LogFile& log,
                                               const simulator::Waypoints& mission) {
    const simulator::LocalFrame frame = frameOf(log, mission);
    const simulator::Plan plan = makePlan(mission, frame);
    const Playback playback(log, plan, frame);
    simulator::Summary summary;
    summary.from_log = true;
    summary.crosstrack_rms_m = playback.metrics.crosstrack.rms();
    summary.crosstrack_max_m = playback.metrics.crosstrack.max();
    summary.altitude_rms_m = playback.metrics.altitude.rms();
    summary.altitude_max_m = playback.metrics.altitude.max();
    summary.airspeed_rms_mps = playback.metrics.airspeed.rms();
    summary.airspeed_min_mps = playback.metrics.slowest_mps;
    const double flight_s = flownIn(log).flight_s;
    if (std::isfinite(flight_s)) summary.flight_time_s = flight_s;
    return deviationsOf(summary);
}

std::map<std::string, double> parametersIn(const LogFile& log) {
    std::map<std::string, double> parameters;
    for (const Record* row : log.named("PARM")) parameters[row->text("Name")] = (*row)["Value"];
    return parameters;
}

// Its heights are those of the items themselves.
simulator::DocumentPlan planIn(const LogFile& log, simulator::Waypoints mission) {
    for (simulator::WaypointItem& item : mission) item.frame = 0;
    simulator::MissionFile file;
    file.items = mission;
    const double radius_m = parameter(log, "WP_LOITER_RAD");
    const auto known_m = std::isfinite(radius_m) ? std::optional<double>(radius_m) : std::nullopt;
    simulator::DocumentPlan plan = planOf(file, known_m);
    if (!mission.empty() && mission[0].index == 0 && !mission[0].isPlaced()) plan.home.reset();
    return plan;
}

}  // namespace

simulator::FlightDocument documentOf(const LogFile& log, const std::string& name) {
    const std::string version = banner(log);
    const Firmware firmware = firmwareOf(log);
    const simulator::Waypoints mission = missionOf(log);
    simulator::FlightDocument document;
    document.kind = "log";
    document.title = name + " · " + (version.empty() ? "firmware unknown" : version);
    document.good = flownIn(log).ended;
    document.verdict = document.good
                           ? "flown and disarmed"
                           : "the log ends before the airplane was disarmed after a flight";
    document.provenance.log = name;
    document.provenance.firmware = version.empty() ? "unknown" : version;
    document.provenance.parameters = parametersIn(log);
    document.plan = planIn(log, mission);
    addSeries(document, log);
    document.events = eventsOf(log, firmware);
    document.bands = bandsOf(log, firmware);
    document.deviations = deviationsIn(log, mission);
    return document;
}

}  // namespace log_tool
