// SPDX-License-Identifier: GPL-3.0-or-later
// A native flight of what stands beyond the two documents' commands: straight on while it climbs, a
// circle left on the next leg's course, pictures by distance, RTL that lands, and a landing broken
// off on the way.
//   beyond_flight MISSION MINUTES_FOLDER
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <vector>

#include "firmware/actuators/camera.hpp"
#include "firmware/mission/mission.hpp"
#include "firmware/state/vehicle.hpp"
#include "host_tests/scenarios/flight_scenario.hpp"
#include "simulator/invariants/watched_board.hpp"

using namespace simulator;
namespace fs = std::filesystem;

namespace {

constexpr int kShutter = 7, kFlap = 8;
constexpr uint64_t kStep_us = 20'000;
constexpr double kTimeLimit_s = 420;
constexpr double kNear_deg = 8.0 / 111'319;
constexpr uint8_t kAuto = 10, kRtl = 11;
// of the mission
constexpr int kContinue = 2, kPictures = 4, kToHeight = 6, kBeforeRtl = 12, kApproach = 17,
              kLanding = 18;

struct Moment {
    double t_s, north_m, east_m, height_m, course_deg, roll_deg;
    int item, flap_us;
};

class BeyondFlight : public FlightScenario {
public:
    BeyondFlight(Board& board, const Waypoints& items)
        : FlightScenario(board, items, kTimeLimit_s, kStep_us,
                         [this](const mavlink::Frame& frame, uint64_t) { hear(frame); },
                         {{"RTL_AUTOLAND", 2},
                          {"RC7_FUNCTION", 10},
                          {"CAM_DURATION", 2},
                          {"RC8_FUNCTION", 3},
                          {"LAND_FLAP_PERCNT", 50}}) {}

    bool fly() {
        while (!flight_.over()) {
            advance();
            look();
            act();
        }
        const bool passed = check();
        if (!passed) printEvents(flight_);
        return passed;
    }

private:
    const Truth& truth() { return board_.world().truth(); }

    // Where the picture was taken, as it is reported.
    void hear(const mavlink::Frame& frame) {
        if (frame.id != mavlink::Wire<mavlink::CameraFeedback>::id) return;
        const auto reported = frame.read<mavlink::CameraFeedback>();
        const Truth& now = truth();
        ++feedbacks_;
        feedback_fits_ = feedback_fits_ && reported.img_idx == feedbacks_ &&
                         std::abs(reported.lat * 1e-7 - now.latitude_deg) < kNear_deg &&
                         std::abs(reported.lng * 1e-7 - now.longitude_deg) < 1.5 * kNear_deg &&
                         std::abs(double(reported.alt_rel) - now.height_m) < 4 &&
                         std::abs(double(reported.roll) - now.roll_rad / kDegree) < 5 &&
                         std::abs(double(reported.alt_msl - reported.alt_rel) - 488) < 5;
    }

    void look() {
        const Truth& now = truth();
        flown_.push_back({seconds(), now.north_m, now.east_m, now.height_m,
                          std::atan2(now.velocity_east_mps, now.velocity_north_mps) / kDegree,
                          now.roll_rad / kDegree, firmware::mission::missionCurrent(),
                          static_cast<int>(std::lround(board_.world().servoPulse_us(kFlap)))});
        const bool held = std::abs(board_.world().servoPulse_us(kShutter) - 1300) < 3;
        if (held && !held_) pictures_.push_back(flown_.back());
        held_ = held;
    }

    // RTL on the way to the one item, a go-around low over the runway.
    void act() {
        const Moment& now = flown_.back();
        const bool flying = flight_.airborne_s().has_value();
        if (flying && rtl_s_ < 0 && now.item == kBeforeRtl && now.north_m < 150) {
            rtl_s_ = now.t_s;
            command(mavlink::MavCmd::do_set_mode, 1, kRtl);
        }
        const bool low = now.item == kLanding && now.height_m < 10;
        if (rtl_s_ >= 0 && around_s_ < 0 && low) {
            around_s_ = now.t_s;
            command(mavlink::MavCmd::do_go_around, 40, 0);
        }
    }

    void command(uint16_t number, float param1, float param2) {
        mavlink::CommandLong message{};
        message.command = number;
        message.param1 = param1;
        message.param2 = param2;
        message.target_system = flight_.telemetry().system;
        message.target_component = flight_.telemetry().component;
        usb_.send(message);
    }

    std::vector<Moment> during(int item, double from_s = 0) const {
        std::vector<Moment> found;
        for (const Moment& moment : flown_)
            if (moment.item == item && moment.t_s >= from_s) found.push_back(moment);
        return found;
    }

    bool straightOn() const {
        const auto flown = during(kContinue);
        if (flown.empty()) return false;
        double max_deg = 0;
        for (const Moment& each : flown)
            max_deg = std::max(max_deg, std::abs(std::remainder(
                                            each.course_deg - flown.front().course_deg, 360.0)));
        std::printf("          turned %.1f degrees, %.1f to %.1f m\n", max_deg,
                    flown.front().height_m, flown.back().height_m);
        return max_deg < 8 && std::abs(flown.back().height_m - 60) < 3;
    }
    bool leftOnCourse() const {
        const auto flown = during(kToHeight);
        if (flown.empty()) return false;
        const Moment& last = flown.back();
        std::printf("          left at %.1f m on %.0f degrees after %.0f s\n", last.height_m,
                    last.course_deg, last.t_s - flown.front().t_s);
        return std::abs(last.height_m - 80) < 6 && std::abs(last.course_deg - 90) < 13;
    }
    // From the place of item 4 to the circle of 60 m round that of item 6, 340 m from it.
    bool slopedToCircle() const {
        double max_m = 0;
        for (const Moment& each : during(kToHeight)) {
            const double along_m = 339 - std::hypot(each.north_m - 701, each.east_m - 100);
            if (along_m > 0 && along_m < 279)
                max_m = std::max(max_m, std::abs(each.height_m - (60 + 20 * along_m / 279)));
        }
        std::printf("          up to %.1f m from the slope\n", max_m);
        return max_m > 0 && max_m < 5;
    }
    // Out for each landing, in when it is broken off and everywhere else.
    bool flapsWereOut() const {
        int max_us = 0, min_us = 3000, around_us = 3000;
        for (const Moment& each : flown_) {
            if (each.item > 0 && each.item < kBeforeRtl) max_us = std::max(max_us, each.flap_us);
            if (each.item != kLanding || each.height_m > 12 || each.t_s < 60) continue;
            if (each.t_s < around_s_) min_us = std::min(min_us, each.flap_us);
        }
        for (const Moment& each : during(kLanding, around_s_))
            if (each.t_s < around_s_ + 15) around_us = std::min(around_us, each.flap_us);
        std::printf("          %d us before, %d us on the final, %d us after it\n", max_us, min_us,
                    around_us);
        return max_us == 1100 && std::abs(min_us - 1500) < 8 && around_us == 1100 &&
               std::abs(flown_.back().flap_us - 1500) < 8;
    }
    bool photographed() const {
        const auto flown = during(kPictures);
        double length_m = 0, farthest_m = 0, nearest_m = 1e9;
        for (size_t i = 1; i < flown.size(); ++i) length_m += between_m(flown[i - 1], flown[i]);
        for (size_t i = 1; i < pictures_.size(); ++i) {
            farthest_m = std::max(farthest_m, between_m(pictures_[i - 1], pictures_[i]));
            nearest_m = std::min(nearest_m, between_m(pictures_[i - 1], pictures_[i]));
        }
        const double wanted = length_m / 25;
        std::printf("          %zu pictures in %.0f m, %.1f to %.1f m apart\n", pictures_.size(),
                    length_m, nearest_m, farthest_m);
        return std::abs(static_cast<double>(pictures_.size()) - wanted) < 2 && nearest_m > 21 &&
               farthest_m < 29 && pictures_.size() == firmware::actuators::cameraTriggerCount();
    }
    // From the tenth second on, for fifteen.
    bool flewInverted() const {
        const auto flown = during(kBeforeRtl);
        if (flown.empty()) return false;
        double lowest_m = 1e9, highest_m = 0, aside_m = 0, least_deg = 180;
        for (const Moment& each : flown) {
            const double at_s = each.t_s - flown.front().t_s;
            if (at_s < 10) continue;
            lowest_m = std::min(lowest_m, each.height_m);
            highest_m = std::max(highest_m, each.height_m);
            aside_m = std::max(aside_m, std::abs(each.east_m - 600));
            if (at_s > 13 && at_s < 25) least_deg = std::min(least_deg, std::abs(each.roll_deg));
        }
        std::printf("          %.1f to %.1f m, up to %.1f m aside, bank at least %.0f degrees\n",
                    lowest_m, highest_m, aside_m, least_deg);
        return lowest_m > 62 && highest_m < 78 && aside_m < 12 && least_deg > 150 &&
               std::abs(flown.back().roll_deg) < 30;
    }
    bool cameHomeToLand() const {
        const auto approach = during(kApproach);
        return rtl_s_ > 0 && !approach.empty() && approach.front().t_s < rtl_s_ + 4 &&
               during(kLanding - 3).empty();
    }
    bool wentAround() const {
        double lowest_m = 1e9, highest_m = 0;
        for (const Moment& each : during(kLanding, around_s_)) {
            if (each.t_s > around_s_ + 15) break;
            lowest_m = std::min(lowest_m, each.height_m);
            highest_m = std::max(highest_m, each.height_m);
        }
        std::printf("          down to %.1f m, up to %.1f m\n", lowest_m, highest_m);
        return around_s_ > 0 && lowest_m > 3 && highest_m > 37 &&
               !during(kApproach, around_s_).empty();
    }
    static double between_m(const Moment& a, const Moment& b) {
        return std::hypot(a.north_m - b.north_m, a.east_m - b.east_m);
    }

    bool check() {
        return printChecks({
            {"CONTINUE_CHANGE_ALT: straight on, up to its altitude", straightOn()},
            {"SET_CAM_TRIGG_DIST: a picture each 25 m, none before or after", photographed()},
            {"CAMERA_FEEDBACK: where each picture was taken",
             feedback_fits_ && feedbacks_ == pictures_.size()},
            {"LOITER_TO_ALT: climbed to along the way", slopedToCircle()},
            {"LOITER_TO_ALT: left at its altitude on the next leg's course", leftOnCourse()},
            {"INVERTED_FLIGHT: upside down along its leg, and back", flewInverted()},
            {"RTL_AUTOLAND: at the nearest DO_LAND_START", cameHomeToLand()},
            {"DO_GO_AROUND: up before it turns, and the landing again", wentAround()},
            {"LAND_FLAP_PERCNT: out for each landing alone", flapsWereOut()},
            {"it landed", flight_.landed_s() && !truth().crashed && seconds() < kTimeLimit_s},
            {"touched down at home", flight_.touchdown_distance_m().value_or(1e9) < 30},
        });
    }

    std::vector<Moment> flown_, pictures_;
    size_t feedbacks_ = 0;
    bool feedback_fits_ = true;
    bool held_ = false;
    double rtl_s_ = -1, around_s_ = -1;
};

}  // namespace

int main(int count, char** words) {
    if (count != 3) {
        std::cerr << "usage: beyond_flight MISSION MINUTES\n";
        return 2;
    }
    const Waypoints items = readWaypoints(words[1]);
    WatchedBoard board(std::make_unique<NativeBoard>(worldAt(items, 4, 330)));
    BeyondFlight flight(board, items);
    const bool passed = flight.fly() && board.held();
    writeMinutes(fs::path(words[2]) / "native_beyond", flight.seconds() / 60);
    return passed ? 0 : 1;
}
