// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/chaos/generator.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "mavlink/all_messages.hpp"
#include "simulator/chaos/dice.hpp"
#include "simulator/devices/faults.hpp"
#include "toolchain/declination/model.hpp"

namespace simulator::chaos {
namespace {

using mavlink::MavCmd;
using Words = std::vector<std::string>;

struct Home {
    double latitude_deg = 47.3977, longitude_deg = 8.5456, altitude_m = 488;
};
constexpr double kMetresPerDegree = 111'319;
constexpr double kAirborne_s = 15;                  // about
constexpr double kLowest_m = 40, kHighest_m = 100;  // to fly at

std::string print(const char* format, double value) {
    char text[60];
    std::snprintf(text, sizeof text, format, value);
    return text;
}
std::string whole(int value) { return std::to_string(value); }

// ---- missions

WaypointItem itemAt(const Home& home, uint16_t command, double east_m, double north_m,
                    double height_m) {
    WaypointItem item;
    item.command = command;
    item.frame = 3;
    item.latitude_deg = home.latitude_deg + north_m / kMetresPerDegree;
    item.longitude_deg =
        home.longitude_deg + east_m / kMetresPerDegree / std::cos(home.latitude_deg * M_PI / 180);
    item.altitude_m = height_m;
    return item;
}

WaypointItem action(uint16_t command, double p1 = 0, double p2 = 0, double p3 = 0, double p4 = 0) {
    WaypointItem item;
    item.command = command;
    item.frame = 3;
    item.params = {p1, p2, p3, p4};
    return item;
}

WaypointItem drawPlace(Dice& dice, const Home& home) {
    constexpr double kFar_m = 350;
    const uint16_t command =
        dice.chance(0.75) ? uint16_t{MavCmd::nav_waypoint}
                          : dice.of<uint16_t>({MavCmd::nav_loiter_turns, MavCmd::nav_loiter_time,
                                               MavCmd::nav_loiter_unlim});
    WaypointItem item = itemAt(home, command, dice.between(-kFar_m, kFar_m),
                               dice.between(-kFar_m, kFar_m), dice.between(kLowest_m, kHighest_m));
    if (item.isCircle())
        item.params[0] = command == MavCmd::nav_loiter_time ? dice.whole(3, 20) : 1;
    return item;
}

// What neither ends the flight nor takes a surface from the pilot.
WaypointItem drawAction(Dice& dice, int items) {
    switch (dice.below(12)) {
        case 0:
            return action(MavCmd::do_change_speed, dice.below(2), dice.between(11, 15), -1);
        case 1:
            return action(MavCmd::do_set_servo, dice.whole(5, 8), dice.whole(1000, 2000));
        case 2:
            return action(MavCmd::do_repeat_servo, dice.whole(5, 8), dice.whole(1000, 2000), 3, 1);
        case 3:
            return action(MavCmd::do_set_relay, 0, dice.below(2));
        case 4:
            return action(MavCmd::do_repeat_relay, 0, 3, 1);
        case 5:
            return action(MavCmd::condition_delay, dice.whole(1, 10));
        case 6:
            return action(MavCmd::condition_distance, dice.whole(20, 150));
        case 7:
            return action(MavCmd::do_digicam_control);
        case 8:
            return action(MavCmd::do_set_cam_trigg_dist, dice.whole(0, 50));
        case 9:
            return action(MavCmd::do_set_home, 1);
        case 10: {
            WaypointItem item = action(MavCmd::condition_change_alt, dice.between(0.5, 2));
            item.altitude_m = dice.between(kLowest_m, kHighest_m);
            return item;
        }
        default:
            return action(MavCmd::do_jump, dice.whole(2, std::max(2, items - 1)), dice.whole(1, 3));
    }
}

Place placeAt(const Home& home, double east_m, double north_m) {
    const WaypointItem item = itemAt(home, 0, east_m, north_m, 0);
    return {item.latitude_deg, item.longitude_deg};
}

// A circle, or a polygon whose corners lie around its middle one after the other.
FenceArea drawZone(Dice& dice, const Home& home, double east_m, double north_m, double size_m) {
    FenceArea area;
    if (dice.chance(0.5)) {
        area.radius_m = std::round(size_m);
        area.rim.push_back(placeAt(home, east_m, north_m));
        return area;
    }
    const int corners = dice.whole(3, 6);
    const double first_rad = dice.between(0, 2 * M_PI);
    for (int i = 0; i < corners; ++i) {
        const double angle_rad = first_rad + 2 * M_PI * i / corners;
        const double away_m = size_m * dice.between(0.8, 1.3);
        area.rim.push_back(placeAt(home, east_m + away_m * std::sin(angle_rad),
                                   north_m + away_m * std::cos(angle_rad)));
    }
    return area;
}

// Home is inside, and no zone to be stayed out of reaches it.
Fence drawFence(Dice dice, const Home& home) {
    Fence fence;
    if (!dice.chance(0.25)) return fence;
    const auto drawInclusion = [&] {
        fence.areas.push_back(drawZone(dice, home, dice.between(-60, 60), dice.between(-60, 60),
                                       dice.between(250, 700)));
    };
    for (int n = dice.whole(0, 2); n > 0; --n) drawInclusion();
    for (int n = dice.whole(0, 3); n > 0 && fence.areas.size() < 3; --n) {
        const double size_m = dice.between(20, 90), direction_rad = dice.between(0, 2 * M_PI);
        const double away_m = dice.between(1.5 * size_m + 60, 400);
        fence.areas.push_back(drawZone(dice, home, away_m * std::sin(direction_rad),
                                       away_m * std::cos(direction_rad), size_m));
        fence.areas.back().inclusion = false;
    }
    if (fence.areas.empty()) drawInclusion();
    if (dice.chance(0.6))
        fence.way_back = placeAt(home, dice.between(-30, 30), dice.between(-30, 30));
    return fence;
}

Waypoints drawMission(Dice& dice, const Home& home) {
    Waypoints mission;
    mission.push_back(itemAt(home, MavCmd::nav_waypoint, 0, 0, home.altitude_m));
    mission.back().frame = 0;
    mission.push_back(action(MavCmd::nav_takeoff, 15));
    mission.back().altitude_m = dice.between(30, 60);
    for (int n = dice.whole(2, 6); n > 0; --n) {
        mission.push_back(drawPlace(dice, home));
        for (int more = dice.whole(-2, 2); more > 0; --more)
            mission.push_back(drawAction(dice, static_cast<int>(mission.size())));
    }
    mission.push_back(itemAt(home, MavCmd::nav_waypoint, -300, -300, 40));
    if (dice.chance(0.3)) mission.push_back(action(MavCmd::do_land_start));
    mission.push_back(itemAt(home, MavCmd::nav_waypoint, -150, -150, 25));
    mission.push_back(itemAt(home, MavCmd::nav_land, 0, 0, 0));
    for (size_t i = 0; i < mission.size(); ++i) {
        mission[i].index = static_cast<int>(i);
        mission[i].current = i == 0;
    }
    return mission;
}

// ---- events

class Drawer {
public:
    Drawer(Dice& dice, const Home& home, const std::vector<ParameterRow>& parameters, Scenario& to)
        : dice_(dice), home_(home), parameters_(parameters), to_(to) {}

    void standsArmed();
    void faults();
    void restarts();
    void pilot();
    void station(bool hostile);

private:
    using Draw = void (Drawer::*)();

    void add(double at_s, Words words) {
        to_.events.push_back({std::round(at_s * 100) / 100, std::move(words)});
    }
    // Half of what a ground station does comes before the flight, where there is time.
    double when() {
        const bool before = to_.begins_s > 0 && dice_.chance(0.5);
        return dice_.between(3, before ? to_.begins_s : to_.seconds - 5);
    }
    const ParameterRow& parameter();
    // Mostly in flight; every fourth from the start on, as it stands, is armed and takes off.
    double fails() {
        const double flies_s = to_.begins_s + kAirborne_s + 10;
        if (dice_.chance(0.25)) return dice_.between(0.5, flies_s);
        return dice_.between(flies_s, to_.seconds - 5);
    }
    double inFlight() { return dice_.between(to_.begins_s + kAirborne_s + 10, to_.seconds - 5); }
    std::string link() { return dice_.chance(0.7) ? "telemetry" : "usb"; }
    std::string value(const ParameterRow& row);
    std::string hex(size_t bytes);
    void fault(double at_s, double longest_s);
    void sag(double at_s);
    void command(const Words& parameters);

    void setParameter();
    bool changesChannels(FaultKind kind) const;
    void setManyParameters();
    void calibrateRadio();
    void armOrDisarm();
    void chooseMode();
    void anyCommand();
    void cutUpload();
    void overrideSticks();
    void setCurrent();
    void clearMission();
    void anyFrame();
    void anyNoise();
    void readLogs();
    void readParameterFile();

    Dice& dice_;
    const Home& home_;
    const std::vector<ParameterRow>& parameters_;
    Scenario& to_;
};

// Nine channels belong to a transmitter. One that has them for a while would have eight and an edge
// too many behind them, which no decoder can know from nine.
bool Drawer::changesChannels(FaultKind kind) const {
    const bool nine = kind == FaultKind::nine_channels;
    if (!nine && kind != FaultKind::extra_edge && kind != FaultKind::missed_edge) return false;
    const std::string other = nine ? "_edge" : ":nine_channels";
    return std::any_of(to_.events.begin(), to_.events.end(), [&](const Event& event) {
        return event.kind() == "fault" && event.words[1].find(other) != std::string::npos;
    });
}

void Drawer::fault(double at_s, double longest_s) {
    for (;;) {
        const auto sensor = static_cast<Faulty>(dice_.below(kFaulty));
        const auto kind = static_cast<FaultKind>(1 + dice_.below(kFaultKinds - 1));
        if (!canFail(sensor, kind) || changesChannels(kind)) continue;
        if (sensor == Faulty::supply) return sag(at_s);
        add(at_s, {"fault", std::string(nameOf(sensor)) + ":" + nameOf(kind),
                   print("%.2f", dice_.between(0.1, longest_s))});
        return;
    }
}

// Not so low that the processor restarts, which `restart` does.
void Drawer::sag(double at_s) {
    add(at_s, {"fault", print("supply:sag_%.2fv", dice_.between(2.75, 4.6)),
               print("%.2f", dice_.between(0.05, 0.4))});
}

// Before the flight: armed, in a mode whose throttle is the firmware's, for whatever comes then.
void Drawer::standsArmed() {
    const double at_s = dice_.between(6, 10);
    const std::string mode = dice_.of<std::string>({"1", "7", "11", "12", "15"});
    add(at_s, {"command", "telemetry", "400", "1", "0", "0", "0", "0", "0", "0"});
    add(at_s + dice_.between(0.5, 5), {"mode", "telemetry", mode});
    if (dice_.chance(0.7)) fault(at_s + dice_.between(0, 15), 30);
    if (dice_.chance(0.3)) fault(at_s + dice_.between(0, 15), 30);
}

// Alone, in pairs that begin together, or in a burst of short ones.
void Drawer::faults() {
    const double at_s = fails();
    switch (dice_.below(3)) {
        case 0:
            return fault(at_s, 40);
        case 1:
            fault(at_s, 40);
            return fault(at_s + dice_.between(0, 5), 40);
        default:
            for (int n = dice_.whole(3, 8); n > 0; --n) fault(at_s + dice_.between(0, 15), 3);
    }
}

void Drawer::restarts() {
    const double at_s = dice_.chance(0.9) ? fails() : when();
    for (int n = dice_.chance(0.8) ? 1 : 3; n > 0; --n)
        add(at_s + dice_.between(0, n),
            {"restart", dice_.of<std::string>({"brown_out", "power_dip", "watchdog", "watchdog",
                                               "watchdog", "button"})});
}

void Drawer::pilot() {
    const double at_s = inFlight();
    const auto stick = [this] { return whole(dice_.chance(0.3) ? 1500 : dice_.whole(1100, 1900)); };
    switch (dice_.below(4)) {
        case 0:
            add(at_s, {"sticks", stick(), stick(), whole(dice_.whole(1100, 1900)), stick()});
            return add(at_s + dice_.between(0.2, 4), {"sticks", "1500", "1500", "1100", "1500"});
        case 1:
            for (int n = dice_.whole(1, 4); n > 0; --n)
                add(at_s + dice_.between(0, 10),
                    {"switch", dice_.of<std::string>(
                                   {"1165", "1300", "1425", "1550", "1690", "1900", "1300"})});
            return;
        default:
            add(at_s, {"transmitter", "off"});
            if (dice_.chance(0.8)) add(at_s + dice_.between(0.2, 40), {"transmitter", "on"});
    }
}

std::string Drawer::value(const ParameterRow& row) {
    switch (dice_.below(10)) {
        case 0:
            return dice_.of<std::string>({"nan", "inf", "-inf", "1e38", "-1e38", "1e-40", "-0"});
        case 1:
            return print("%.6g", row.highest + dice_.between(0, 2) * (row.highest - row.lowest));
        case 2:
            return print("%.6g", row.lowest - dice_.between(0, 2) * (row.highest - row.lowest));
        case 3:
            return print("%.6g", dice_.chance(0.5) ? row.lowest : row.highest);
        default:
            return print("%.6g", dice_.between(row.lowest, row.highest));
    }
}

std::string Drawer::hex(size_t bytes) {
    std::string text;
    char pair[3];
    for (size_t i = 0; i < bytes; ++i) {
        const auto byte = static_cast<unsigned>(dice_.chance(0.4) ? 0 : dice_.below(256));
        std::snprintf(pair, sizeof pair, "%02x", byte);
        text += pair;
    }
    return text;
}

// Every third is one of those that move the motor and the surfaces.
const ParameterRow& Drawer::parameter() {
    const bool moves = dice_.chance(0.33);
    for (;;) {
        const ParameterRow& row = dice_.of(parameters_);
        if (!moves || row.name.rfind("RC", 0) == 0 || row.name.rfind("THR", 0) == 0) return row;
    }
}

void Drawer::setParameter() {
    const ParameterRow& row = parameter();
    add(when(), {"param", link(), row.name, value(row)});
}

void Drawer::setManyParameters() {
    const double at_s = when();
    const std::string on = link();
    for (int n = dice_.whole(10, 40), i = 0; i < n; ++i) {
        const ParameterRow& row = parameter();
        add(at_s + 0.05 * i, {"param", on, row.name, value(row)});
    }
}

// As a ground station's page for it ends: ends, middle and direction of every channel, from a
// transmitter that may be set in any way.
void Drawer::calibrateRadio() {
    const double at_s = when();
    const std::string on = link();
    int sent = 0;
    const auto set = [&](int channel, const char* what, int to) {
        const std::string name = "RC" + whole(channel) + "_" + what;
        add(at_s + 0.05 * sent++, {"param", on, name, whole(to)});
    };
    for (int channel = 1; channel <= 4; ++channel) {
        set(channel, "MIN", dice_.whole(950, 1300));
        set(channel, "MAX", dice_.whole(1750, 2050));
        set(channel, "TRIM", dice_.whole(1400, 1600));
        set(channel, "REV", dice_.chance(0.3) ? -1 : 1);
    }
}

void Drawer::command(const Words& parameters) {
    Words words = {"command", link()};
    words.insert(words.end(), parameters.begin(), parameters.end());
    words.resize(10, "0");
    add(when(), words);
}

void Drawer::armOrDisarm() {
    const bool force = dice_.chance(0.1);
    command({"400", whole(dice_.whole(0, 1)), force ? "21196" : "0"});
}

void Drawer::chooseMode() { add(when(), {"mode", link(), whole(dice_.whole(0, 17))}); }

void Drawer::anyCommand() {
    const std::string number = dice_.of<std::string>(
        {"16",  "17",  "20",  "21",  "22",  "112", "176",   "177",  "178", "179",
         "180", "181", "182", "183", "184", "186", "189",   "191",  "192", "203",
         "206", "207", "210", "224", "241", "242", "245",   "300",  "400", "401",
         "410", "510", "511", "512", "519", "520", "42424", "42425"});
    Words words = {number};
    for (int i = 0; i < 7; ++i)
        words.push_back(dice_.of<std::string>(
            {"0", "0", "1", "2", "-1", "nan", "1e30", print("%.4g", dice_.between(-100, 2000))}));
    command(words);
}

void Drawer::cutUpload() {
    const double at_s = when();
    const std::string on = link();
    const Waypoints other = drawMission(dice_, home_);
    const int count = static_cast<int>(other.size()), sent = dice_.whole(0, count);
    add(at_s, {"count", on, whole(count)});
    for (int i = 0; i < sent; ++i) {
        const WaypointItem& item = other[static_cast<size_t>(i)];
        Words words = {"item", on, whole(i), whole(item.command), whole(item.frame)};
        for (const double each : item.params) words.push_back(print("%.6g", each));
        words.push_back(print("%.7f", item.latitude_deg));
        words.push_back(print("%.7f", item.longitude_deg));
        words.push_back(print("%.6g", item.altitude_m));
        add(at_s + 0.1 + 0.08 * i, words);
    }
}

void Drawer::overrideSticks() {
    Words words = {"override", link()};
    for (int i = 0; i < 8; ++i)
        words.push_back(dice_.of<std::string>({"0", "65535", whole(dice_.whole(700, 2300))}));
    add(when(), words);
}

void Drawer::setCurrent() { add(when(), {"current", link(), whole(dice_.whole(0, 12))}); }
void Drawer::clearMission() { add(when(), {"clear", link()}); }

void Drawer::anyFrame() {
    const size_t row = dice_.below(core::count(mavlink::kAllMessages));
    const mavlink::Accepted message = core::romRead(mavlink::kAllMessages[row]);
    // the radio's report of its buffers throttles the link, the logs' erasure takes them away
    constexpr uint16_t kNot[] = {109, 121};
    if (std::find(std::begin(kNot), std::end(kNot), message.id) != std::end(kNot)) return;
    add(when(), {"frame", link(), whole(message.id), hex(dice_.below(60) + 1)});
}

void Drawer::anyNoise() { add(when(), {"noise", link(), hex(dice_.below(120) + 1)}); }

// LOG_REQUEST_LIST and LOG_REQUEST_DATA.
void Drawer::readLogs() {
    const std::string on = link();
    const double at_s = when();
    add(at_s, {"frame", on, "117", "0000ffff0101"});
    add(at_s + 1, {"frame", on, "119", "00000000ffffffff01000101"});
}

// FILE_TRANSFER_PROTOCOL: @PARAM/param.pck opened, then BurstReadFile from somewhere.
void Drawer::readParameterFile() {
    const std::string on = link();
    const double at_s = when();
    add(at_s, {"frame", on, "110",
               "0001010000000410000000000000004050415241"
               "4d2f706172616d2e70636b"});
    const std::string offset[] = {"0000", "0004", "200a"};
    add(at_s + 0.5,
        {"frame", on, "110", "0001010100000f50000000" + offset[dice_.below(3)] + "0000"});
}

// An honest one that is confused, or one that wants harm.
void Drawer::station(bool hostile) {
    struct Row {
        Draw draw;
        unsigned weight, hostile_weight;
    };
    static constexpr Row kRows[] = {
        {&Drawer::setParameter, 4, 4},   {&Drawer::setManyParameters, 0, 1},
        {&Drawer::calibrateRadio, 2, 2}, {&Drawer::armOrDisarm, 2, 3},
        {&Drawer::chooseMode, 4, 4},     {&Drawer::anyCommand, 1, 8},
        {&Drawer::cutUpload, 2, 2},      {&Drawer::overrideSticks, 0, 2},
        {&Drawer::setCurrent, 2, 2},     {&Drawer::clearMission, 1, 1},
        {&Drawer::anyFrame, 0, 8},       {&Drawer::anyNoise, 2, 3},
        {&Drawer::readLogs, 1, 1},       {&Drawer::readParameterFile, 1, 1},
    };
    unsigned sum = 0;
    for (const Row& row : kRows) sum += hostile ? row.hostile_weight : row.weight;
    auto at = static_cast<unsigned>(dice_.below(sum));
    for (const Row& row : kRows) {
        const unsigned weight = hostile ? row.hostile_weight : row.weight;
        if (at < weight) return (this->*row.draw)();
        at -= weight;
    }
}

constexpr double kYear = 2026.9;

declination::Model readMagneticModel() {
    std::ifstream file(CHAOS_MAGNETIC_MODEL);
    if (!file) throw ScenarioError(CHAOS_MAGNETIC_MODEL ": cannot be read");
    return declination::Model(file);
}

// A field anywhere, but where a compass shows the way and the firmware knows the declination.
Home drawHome(Dice& dice, Conditions& drawn) {
    static const declination::Model model = readMagneticModel();
    constexpr double kLeastLevelField_mg = 80;
    for (;;) {
        Home home;
        home.latitude_deg = dice.whole(-600'000, 600'000) * 1e-4;
        home.longitude_deg = dice.whole(-1'790'000, 1'790'000) * 1e-4;
        home.altitude_m = dice.whole(0, 2000);
        const auto field =
            model.at(home.latitude_deg, home.longitude_deg, home.altitude_m / 1000, kYear);
        const double level_mg = field.horizontal_nt() / 100, down_mg = field.down_nt / 100;
        const auto rounded = [](double value) { return std::round(value * 100) / 100; };
        drawn.declination_deg = rounded(field.declination_deg());
        drawn.inclination_deg = rounded(std::atan2(down_mg, level_mg) * 180 / M_PI);
        drawn.magnetic_field_mg = rounded(std::hypot(level_mg, down_mg));
        if (level_mg >= kLeastLevelField_mg) return home;
    }
}

// By dice of its own, so that the rest of a scenario does not depend on it.
Home drawWorld(Dice dice, Scenario& s) {
    Conditions& drawn = s.conditions;
    const auto tenths = [&](double from, double to) {
        return std::round(dice.between(from, to) * 10) / 10;
    };
    Home home;
    if (dice.chance(0.5)) home = drawHome(dice, drawn);
    drawn.tube = dice.chance(0.3) ? 0 : 1;
    if (dice.chance(0.5)) drawn.gps_latency_s = dice.whole(50, 400) * 0.001;
    if (dice.chance(0.5)) {
        drawn.board_warmth_c = tenths(0, 20);
        drawn.board_warmth_start_c = tenths(-10, 25);
    }
    if (dice.chance(0.5)) drawn.band_gap_v = dice.whole(1001, 1199) * 0.001;  // 9 %
    if (dice.chance(0.1)) drawn.worn_cells = dice.whole(1, 20);
    drawn.bootloader = dice.of<double>({0, 0, 1, 2});
    if (dice.chance(0.15)) {
        s.wind_mps = tenths(7, 12);
        s.wind_from_deg = dice.whole(0, 359);
        s.gusts = true;
    }
    return home;
}

}  // namespace

// Without the rate of a line, or under another name, the board would not be heard any more.
std::vector<ParameterRow> readParameterRows(const std::string& csv_path) {
    std::ifstream file(csv_path);
    if (!file) throw ScenarioError(csv_path + ": cannot be read");
    std::vector<ParameterRow> rows;
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        std::istringstream columns(line);
        std::string name, unit, lowest, highest;
        std::getline(columns, name, ',');
        std::getline(columns, unit, ',');
        std::getline(columns, lowest, ',');
        std::getline(columns, highest, ',');
        if (name.rfind("SERIAL", 0) == 0 || name.rfind("SYSID", 0) == 0 || name.empty() ||
            name == "FORMAT_VERSION")
            continue;
        rows.push_back({name, std::atof(lowest.c_str()), std::atof(highest.c_str())});
    }
    return rows;
}

Scenario drawScenario(uint64_t seed, const std::vector<ParameterRow>& parameters) {
    Dice dice(seed);
    Scenario s;
    s.seed = seed;
    s.airplane = dice.of<std::string>({"foam_trainer", "trainer_6kg", "flying_wing"});
    if (dice.chance(0.6)) {
        s.wind_mps = std::round(dice.between(1, 7) * 10) / 10;
        s.wind_from_deg = dice.whole(0, 359);
        s.gusts = true;
    }
    // by dice of their own: what a seed has drawn before stays
    constexpr uint64_t kOther = 0x9E3779B97F4A7C15, kFences = 0xD1B54A32D192ED03;
    const Home home = drawWorld(Dice(seed ^ kOther), s);
    s.fence = drawFence(Dice(seed ^ kFences), home);
    s.seconds = dice.whole(60, 180);
    if (dice.chance(0.25)) s.begins_s = dice.whole(10, 25);
    s.mission = drawMission(dice, home);
    Drawer drawer(dice, home, parameters, s);
    if (dice.chance(0.5)) s.events.push_back({1, {"usb", "on"}});
    if (s.begins_s > 0 && dice.chance(0.5)) {
        s.begins_s += 15;
        s.seconds += 15;
        drawer.standsArmed();
    }
    if (dice.chance(0.6))
        for (int n = dice.whole(1, 2); n > 0; --n) drawer.faults();
    if (dice.chance(0.4)) drawer.restarts();
    if (dice.chance(0.4))
        for (int n = dice.whole(1, 3); n > 0; --n) drawer.pilot();
    if (dice.chance(0.5)) {
        const bool hostile = dice.chance(0.5);
        for (int n = dice.whole(1, hostile ? 20 : 6); n > 0; --n) drawer.station(hostile);
    }
    std::stable_sort(s.events.begin(), s.events.end(),
                     [](const Event& a, const Event& b) { return a.at_s < b.at_s; });
    return s;
}

}  // namespace simulator::chaos
