// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/invariants/watch.hpp"

#include <cstdarg>
#include <cstdio>

namespace simulator::invariants {

const std::vector<InvariantRow> kInvariants = {
    {"motor_idle_disarmed", "Disarmed, the motor's pulse is its idle.", motorIdleWhenDisarmed},
    {"motor_idle_standing", "Standing on the ground, the motor runs only when that was asked for.",
     motorIdleOnTheGround},
    {"armed_by_itself", "Nothing arms but a command or the rudder stick.", armedByACommand},
    {"armed_in_the_air", "In the air nothing but a forced command disarms.", armedInTheAir},
    {"surface_at_its_stop", "No surface stays at its stop for two seconds.", surfacesOffTheirStops},
    {"surface_swings", "No surface swings between its sides.", surfacesDoNotSwing},
    {"mode_without_cause", "The mode changes only for a cause that can be stated.", modeHasACause},
    {"mission_jump", "The mission goes on item by item, or as it is reported.", missionDoesNotJump},
    {"restart_in_the_air",
     "After a restart in the air the surfaces move, and it is armed as before.",
     fliesOnAfterARestart},
    {"standing_report", "Standing, it reports neither motion nor another place.", standsStill},
    {"restart_by_itself", "The processor restarts only when something makes it.",
     noRestartByItself},
    {"late_frame", "Every frame is done in its time, and the stack within the memory.",
     frameInTime},
};

namespace {

constexpr double kAgain_s = 10;  // the same violation is listed once in that time
constexpr size_t kMaxViolations = 100;

}  // namespace

std::string text(const char* format, ...) {
    char line[300];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    return line;
}

std::string Violation::line() const {
    return text("%.2f s %s: %s", time_s, name.c_str(), numbers.c_str());
}

Watch::Watch() {
    for (const InvariantRow& row : kInvariants) held_.push_back({&row, row.make()});
}

template <class Call>
void Watch::each(Call call) {
    for (Held& held : held_) {
        if (excused_.count(held.row->name) != 0) continue;
        call(*held.invariant, [&](double time_s, const std::string& numbers) {
            if (now_s_ - held.violated_s < kAgain_s || violations_.size() >= kMaxViolations) return;
            held.violated_s = now_s_;
            violations_.push_back({time_s, held.row->name, numbers});
        });
    }
}

void Watch::frame(const Snapshot& now) {
    now_s_ = now.time_s();
    history_.frame(now);
    each([&](Invariant& invariant, const Invariant::Report& report) {
        invariant.frame(now, history_, report);
    });
}

void Watch::provokedRestart(bool survivable) {
    ++provoked_.restarts;
    provoked_.survivable = survivable;
    for (Held& held : held_) held.invariant->provoked(provoked_);
}

void Watch::end(const BoardFigures& figures) {
    if (ended_) return;
    ended_ = true;
    each([&](Invariant& invariant, const Invariant::Report& report) {
        invariant.end(now_s_, figures, report);
    });
}

}  // namespace simulator::invariants
