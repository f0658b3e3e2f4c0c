// SPDX-License-Identifier: GPL-3.0-or-later
// A sentence that has to hold in every flight, and what finds out when it does not.
#pragma once
#include <functional>
#include <memory>
#include <string>

#include "simulator/board.hpp"
#include "simulator/invariants/history.hpp"

namespace simulator::invariants {

struct Violation {
    double time_s = 0;
    std::string name, numbers;

    std::string line() const;  // for people
};

// What a flight had to bear that nobody in it has done: tests and drills provoke it.
struct Provoked {
    unsigned restarts = 0;
    bool survivable = false;  // the last one: by the watchdog, a fault or the supply
};

class Invariant {
public:
    using Report = std::function<void(double time_s, const std::string& numbers)>;

    virtual ~Invariant() = default;
    virtual void frame(const Snapshot& now, const History& history, const Report& report) = 0;
    // Once, when the flight is over.
    virtual void end(double, const BoardFigures&, const Report&) {}
    virtual void provoked(const Provoked&) {}
};

struct InvariantRow {
    const char* name;
    const char* sentence;
    std::unique_ptr<Invariant> (*make)();
};

std::string text(const char* format, ...) __attribute__((format(printf, 1, 2)));

// One function each, in the file of its subject.
std::unique_ptr<Invariant> motorIdleWhenDisarmed();
std::unique_ptr<Invariant> motorIdleOnTheGround();
std::unique_ptr<Invariant> armedByACommand();
std::unique_ptr<Invariant> armedInTheAir();
std::unique_ptr<Invariant> surfacesOffTheirStops();
std::unique_ptr<Invariant> surfacesDoNotSwing();
std::unique_ptr<Invariant> modeHasACause();
std::unique_ptr<Invariant> missionDoesNotJump();
std::unique_ptr<Invariant> fliesOnAfterARestart();
std::unique_ptr<Invariant> standsStill();
std::unique_ptr<Invariant> noRestartByItself();
std::unique_ptr<Invariant> frameInTime();

}  // namespace simulator::invariants
