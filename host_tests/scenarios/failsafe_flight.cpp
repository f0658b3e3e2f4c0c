// SPDX-License-Identifier: GPL-3.0-or-later
// A flight through the transitions of docs/failsafes.md, each provoked as it would be in the air:
// the radio, the receiver and the ground station fall silent, the fence is crossed, the pack is
// low. Fails when another mode than the row's is flown, now or afterwards, when its text is
// missing, or when the airplane does not stay in hand. Row 1, of the inertial sensor, is
// fault_flight's.
//   failsafe_flight native|FIRMWARE MISSION OUT MINUTES_FOLDER
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <map>

#include "firmware/safety/failsafe_table.hpp"
#include "host_tests/scenarios/flight_scenario.hpp"
#include "simulator/devices/ppm_encoder.hpp"

using namespace simulator;

namespace {

constexpr uint64_t kStep_us = 20'000;
constexpr double kFrom_s = 15;  // in the air and past the take-off
constexpr double kLongTimeout_s = 2;
constexpr double kAnswered_s = 0.2;
constexpr double kHolds_s = 2.5;   // the mode is sent once a second
constexpr double kReturns_s = 15;  // a receiver that was off has to find its fix

constexpr uint32_t kCircle = 1, kFbwa = 5, kAuto = 10, kRtl = 11, kLoiter = 12, kGuided = 15;

// What falls silent or is crossed.
enum Trouble : unsigned {
    kNone = 0,
    kRadio = 1,
    kGps = 2,
    kGround = 4,
    kFence = 8,
    kPack = 16,
    kWind = 32
};

using Settings = std::map<std::string, float>;
struct Row {
    int number;  // of the table
    const char* what;
    uint32_t flown;
    unsigned from_before;  // troubles that are there already, and overruled
    unsigned trouble;
    Settings settings;
    const char* text;             // expected
    std::vector<uint32_t> modes;  // in turn, the last one stays
    double within_s;
    uint32_t afterwards;
};

// clang-format off
const Settings kShortOnly = {{"FS_LONG_TIMEOUT", 20}};
const Settings kCircles = {{"FS_LONG_TIMEOUT", 20}, {"FS_SHORT_ACTN", 1}};
const Settings kGlides = {{"FS_LONG_TIMEOUT", 20}, {"FS_SHORT_ACTN", 2}};
const Settings kGroundReturns = {{"FS_GCS_ENABL", 1}, {"FS_LONG_ACTN", 1}};
constexpr char kShort[] = "Radio lost: short failsafe", kLong[] = "Radio lost: long failsafe";
const Row kRows[] = {
    //   what happens                flown    before trouble  settings             modes            within, afterwards
    {12, "radio, by the pilot",      kFbwa,   kNone, kRadio,  kShortOnly,          kShort, {kCircle},        3, kFbwa},
    {13, "radio, by itself",         kLoiter, kNone, kRadio,  kCircles,            kShort, {kCircle},        3, kLoiter},
    {11, "radio, by itself",         kAuto,   kNone, kRadio,  kGlides,             kShort, {kFbwa},          3, kAuto},
    {6,  "long, by the pilot",       kFbwa,   kNone, kRadio,  {},                  kLong,  {kCircle, kRtl},  6, kRtl},
    {7,  "ground station",           kLoiter, kNone, kGround, kGroundReturns,
         "Ground station lost: failsafe",                                                  {kRtl},           5, kRtl},
    {8,  "long, by itself",          kAuto,   kNone, kRadio,  {{"FS_SHORT_ACTN", 1}}, kLong, {kCircle, kRtl}, 6, kRtl},
    {5,  "long, by itself, glide",   kAuto,   kNone, kRadio,  {{"FS_LONG_ACTN", 2}},  kLong, {kFbwa},        6, kFbwa},
    {2,  "fence",                    kLoiter, kNone, kFence,  {{"FENCE_ACTION", 1}},
         "Fence breach: too high",                                                         {kGuided},        4, kGuided},
    {14, "position",                 kAuto,   kNone, kGps,    {},  "Position lost",        {kCircle},       26, kAuto},
    {9,  "long, by the pilot, nowhere", kFbwa, kGps, kRadio,  {},                  kLong,  {kCircle},        6, kFbwa},
    {10, "long, by itself, nowhere", kAuto,   kGps,  kRadio,  {{"FS_LONG_ACTN", 1}},  kLong, {kCircle},      6, kAuto},
    {4,  "headwind",                 kLoiter, kNone, kWind,   {},  "Headwind too strong",  {kRtl},          90, kRtl},
    // the last one: a pack that was low stays low
    {3,  "battery",                  kAuto,   kNone, kPack,   {},  "Battery low",          {kRtl},          15, kRtl},
};
// clang-format on
static_assert(std::size(kRows) == firmware::safety::kTransitionCount - 1, "a row is not flown");

const Settings kUsual = {{"FS_SHORT_ACTN", 0},
                         {"FS_LONG_ACTN", 0},
                         {"FS_GCS_ENABL", 0},
                         {"FENCE_ACTION", 0},
                         {"FS_LONG_TIMEOUT", kLongTimeout_s}};

class FailsafeFlight : FlightScenario {
public:
    FailsafeFlight(Board& board, const Waypoints& items)
        : FlightScenario(board, items, 900, kStep_us) {}

    bool fly() {
        while (goOn() && sinceAirborne_s() <= kFrom_s) {
        }
        board_.world().radio().sticks({1500, 1500, 1550, 1500, 1500, 1500, 1500, 1425}, true);
        sendFence();
        bool passed = true;
        for (const Row& row : kRows) passed = flyRow(row) && passed;
        const Check whole[] = {
            {"no frame was late", !frameWasLate()},
            {"the airplane stayed in hand", lowest_m_ > 25 && max_bank_deg_ < 60},
            {"the flight went on to its end", !flight_.over()},
        };
        passed_ = printChecks(whole) && passed;
        if (!passed_) printEvents(flight_);
        return passed_;
    }

    Summary summary(const std::string& firmware, const WorldOptions& world) const {
        return summarised("every failsafe", passed_, firmware, world);
    }

private:
    uint32_t mode() const { return flight_.telemetry().mode(); }

    bool goOn() {
        advance((troubles_ & kGround) == 0);
        blow();
        const Truth& truth = board_.world().truth();
        if (!begun_) return !flight_.over();  // the take-off
        lowest_m_ = std::min(lowest_m_, truth.height_m);
        max_bank_deg_ = std::max(max_bank_deg_, std::abs(truth.roll_rad) / kDegree);
        if (modes_.empty() || modes_.back() != mode()) modes_.push_back(mode());
        return !flight_.over();
    }
    void wait(double time_s) {
        waitUntil(time_s, [] { return false; });
    }
    template <class Done>
    bool waitUntil(double time_s, Done done) {
        const double end_s = seconds() + time_s;
        while (!done() && seconds() < end_s && goOn()) {
        }
        return done();
    }

    bool flyRow(const Row& row) {
        begun_ = true;
        return prepare(row) && act(row) && release(row);
    }

    bool prepare(const Row& row) {
        begin(row.from_before);
        said_ = flight_.telemetry().texts.size();
        if ((row.from_before & kGps) != 0)
            waitUntil(26, [this] { return hasText("Position lost"); });
        Settings settings = row.settings;
        settings.insert(kUsual.begin(), kUsual.end());
        for (const auto& setting : settings) set(setting.first, setting.second);
        enableFence(row.trouble == kFence);
        return expect(row, choose(row.flown), "was not entered");
    }

    bool act(const Row& row) {
        const double from_s = seconds();
        said_ = flight_.telemetry().texts.size();
        modes_.clear();
        begin(row.from_before | row.trouble);
        std::vector<uint32_t> wanted = row.modes;
        if (wanted[0] != row.flown) wanted.insert(wanted.begin(), row.flown);
        const bool acted = waitUntil(row.within_s, [&] { return modes_ == wanted; });
        const double took_s = seconds() - from_s;
        wait(kHolds_s);
        const bool glides = wanted.back() != kFbwa || board_.world().truth().throttle < 0.05;
        if (!expect(row, acted && modes_ == wanted, "flew " + modesSeen()) ||
            !expect(row, hasText(row.text), std::string("no text: ") + row.text) ||
            !expect(row, glides, "the motor runs in the glide"))
            return false;
        std::printf("  ok      row %-2d %s: %s in %.1f s, \"%s\"\n", row.number, row.what,
                    modesSeen().c_str(), took_s, row.text);
        return true;
    }

    bool release(const Row& row) {
        begin(kNone);
        waitUntil(kReturns_s, [&] { return mode() == row.afterwards; });
        wait(kHolds_s);
        return expect(row, mode() == row.afterwards, "afterwards " + modeName(mode()));
    }

    bool expect(const Row& row, bool passed, const std::string& otherwise) const {
        if (!passed)
            std::printf("  FAILED  row %-2d %s: %s\n", row.number, row.what, otherwise.c_str());
        return passed;
    }

    void begin(unsigned troubles) {
        std::vector<Fault> faults;
        if ((troubles & kRadio) != 0) faults.push_back({Faulty::radio, FaultKind::lost});
        if ((troubles & kGps) != 0) faults.push_back({Faulty::gps, FaultKind::lost});
        board_.world().setFaults(faults);
        set("FENCE_MAXALT", (troubles & kFence) != 0 ? 20 : 500);
        set("FS_BATT_VOLTAGE", (troubles & kPack) != 0 ? 60 : 0);
        board_.setUsb((troubles & kPack) == 0);  // on USB there is no pack to watch
        troubles_ = troubles;
    }

    // It freshens until it is faster than ARSPD_FBW_MAX, and drops again, by 1 m/s each second.
    void blow() {
        constexpr double kStorm_mps = 28, kStep_mps = 1e-6 * kStep_us;
        const double wanted_mps = (troubles_ & kWind) != 0 ? kStorm_mps : 0;
        wind_mps_ += std::clamp(wanted_mps - wind_mps_, -kStep_mps, kStep_mps);
        board_.world().setWind(wind_mps_, 0);
    }

    bool choose(uint32_t wanted) {
        for (int tries = 0; tries < 3; ++tries) {
            mavlink::SetMode message{};
            message.target_system = flight_.telemetry().system;
            message.base_mode = 1;  // MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
            message.custom_mode = wanted;
            usb_.send(message);
            if (waitUntil(2, [&] { return mode() == wanted; })) break;
        }
        wait(1);
        return mode() == wanted;
    }

    // A square of 4 km, the way back to its middle. The vehicle asks for one after the other.
    void sendFence() {
        constexpr double kNorth_deg = 0.018, kEast_deg = 0.027;
        constexpr int kPoints[][2] = {{0, 0}, {1, 1}, {1, -1}, {-1, -1}, {-1, 1}};
        mavlink::MissionCount count{};
        count.count = std::size(kPoints);
        sendOfFence(count);
        for (size_t i = 0; i < std::size(kPoints); ++i) {
            mavlink::MissionItemInt item{};
            item.seq = static_cast<uint16_t>(i);
            item.command = i == 0 ? mavlink::MavCmd::nav_fence_return_point
                                  : mavlink::MavCmd::nav_fence_polygon_vertex_inclusion;
            item.param1 = std::size(kPoints) - 1;
            item.x = degreesE7(items_[0].latitude_deg + kNorth_deg * kPoints[i][0]);
            item.y = degreesE7(items_[0].longitude_deg + kEast_deg * kPoints[i][1]);
            sendOfFence(item);
        }
    }
    static int32_t degreesE7(double degrees) { return static_cast<int32_t>(degrees * 1e7); }
    template <class Message>
    void sendOfFence(Message& message) {
        message.target_system = flight_.telemetry().system;
        message.target_component = 1;
        message.mission_type = mavlink::MavMissionType::fence;
        usb_.send(message);
        wait(kAnswered_s);
    }

    void enableFence(bool on) {
        mavlink::CommandLong message{};
        message.command = mavlink::MavCmd::do_fence_enable;
        message.target_system = flight_.telemetry().system;
        message.target_component = 1;
        message.param1 = on;
        usb_.send(message);
        wait(kAnswered_s);
    }

    // One message at a time, as a ground station does that waits for the answers.
    void set(const std::string& name, float value) {
        const auto sent = sent_.find(name);
        if (sent != sent_.end() && sent->second == value) return;
        sent_[name] = value;
        send(name.c_str(), value);
        wait(kAnswered_s);
    }

    bool hasText(const std::string& part) const {
        const auto& texts = flight_.telemetry().texts;
        return std::any_of(texts.begin() + static_cast<std::ptrdiff_t>(said_), texts.end(),
                           [&](const Event& text) { return text.text.find(part) != part.npos; });
    }
    std::string modesSeen() const {
        std::string all;
        for (const uint32_t mode : modes_) all += (all.empty() ? "" : ", ") + modeName(mode);
        return all;
    }

    unsigned troubles_ = kNone;
    double wind_mps_ = 0;
    bool begun_ = false, passed_ = false;
    size_t said_ = 0;              // texts before this row, then before its trouble
    std::vector<uint32_t> modes_;  // since then
    std::map<std::string, float> sent_;
    double lowest_m_ = 1e9, max_bank_deg_ = 0;
};

}  // namespace

int main(int count, char** words) {
    if (count != 5) {
        std::cerr << "usage: failsafe_flight native|FIRMWARE MISSION OUT MINUTES\n";
        return 2;
    }
    const Waypoints items = readWaypoints(words[2]);
    return flyAndCheck<FailsafeFlight>(words[1], gustyWorldAt(items, 4, 11), words[3], words[4],
                                       items);
}
