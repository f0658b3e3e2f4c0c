// SPDX-License-Identifier: GPL-3.0-or-later
// AUTOTUNE as a pilot uses it after his first take-off, by radio and by the ground link alone.
#pragma once
#include <functional>
#include <string>

#include "simulator/ground/link.hpp"
#include "simulator/ground/scripted_flight.hpp"
#include "simulator/ground/tuning_pilot.hpp"
#include "simulator/invariants/watched_board.hpp"

namespace simulator::drawn {

class Tuning {
public:
    // `settings` are set by wire before; the mission `items` takes off.
    Tuning(WatchedBoard& board, const Waypoints& items, const ParameterSettings& settings);

    // Empty when it has been flown to its end; else why not.
    std::string fly();
    // What AUTOTUNE has learnt, as the autopilot has it now.
    ParameterSettings found();
    const std::vector<Event>& texts() const { return flight_.telemetry().texts; }

private:
    static constexpr int kTelemetry = 2, kUsb = 0;

    bool advance();
    bool advanceFor(double seconds, const std::function<void(double)>& each);
    void chooseAutotune();

    WatchedBoard& board_;
    TuningPilot pilot_;
    ScriptedFlight flight_;
    Link usb_;
    ParameterSettings answers_;
};

}  // namespace simulator::drawn
