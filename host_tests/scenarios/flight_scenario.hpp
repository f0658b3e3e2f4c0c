// SPDX-License-Identifier: GPL-3.0-or-later
// What the flights that check themselves are made of: a scripted flight on a board, by the image or
// natively, with a second link at the USB port, recorded; and their folders and exit status.
#pragma once
#include <cmath>
#include <memory>

#include "host_tests/scenarios/flight_report.hpp"
#include "host_tests/scenarios/station.hpp"
#include "simulator/ground/link.hpp"
#include "simulator/invariants/watched_board.hpp"
#include "simulator/machine/apm2_board.hpp"
#include "simulator/native/native_board.hpp"
#include "simulator/report/recorder.hpp"

namespace simulator {

constexpr double kDegree = M_PI / 180;

// A steady wind from 320 degrees, with gusts.
inline WorldOptions gustyWorldAt(const Waypoints& items, double wind_mps, uint64_t seed) {
    WorldOptions world = worldAt(items, wind_mps, 320);
    world.gusts = true;
    world.seed = seed;
    return world;
}

class FlightScenario {
public:
    double seconds() const { return static_cast<double>(board_.time_us()) * 1e-6; }

protected:
    static constexpr int kTelemetry = 2, kUsb = 0;
    static constexpr uint64_t kSample_us = 100'000;

    // Ends after `limit_s` of emulated time; `step_us` is the time between two looks at the flight.
    FlightScenario(
        Board& board, const Waypoints& items, double limit_s, uint64_t step_us,
        const Link::Handler& fromUsb = [](const mavlink::Frame&, uint64_t) {},
        const ParameterSettings& settings = {})
        : items_(items),
          frame_(items[0].latitude_deg, items[0].longitude_deg),
          plan_(makePlan(items, frame_)),
          board_(board),
          flight_(board, kTelemetry, items_, limit_s, settings),
          usb_(board, kUsb, fromUsb),
          recorder_(plan_, frame_),
          step_us_(step_us) {
        board_.listen([this](int usart, uint8_t byte, uint64_t at_us) {
            if (usart == kTelemetry) flight_.receive(byte, at_us);
            if (usart == kUsb) usb_.receive(byte, at_us);
        });
        board_.setUsb(true);
        switchTransmitterOn(board_.world());
    }

    // One step; false when the flight is over. The ground station of the telemetry port may be
    // silent.
    bool advance(bool ground_station = true) {
        if (!board_.runUntil(++step_ * step_us_)) flight_.stop(board_.fault());
        if (ground_station) flight_.step(board_.time_us());
        if (step_ * step_us_ % kSample_us == 0)
            recorder_.sample(board_, flight_.telemetry(), {}, {});
        return !flight_.over();
    }
    // Since the take-off; -1 before it.
    double sinceAirborne_s() const {
        return flight_.airborne_s() ? seconds() - *flight_.airborne_s() : -1;
    }
    void send(const char* parameter, float value) {
        usb_.send(paramSet(flight_.telemetry().system, parameter, value));
    }
    bool frameWasLate() const { return board_.figures().frame_overruns.value_or(0) != 0; }
    Summary summarised(const char* mission, bool completed, const std::string& firmware,
                       const WorldOptions& world) const {
        Summary s = summaryOf(board_, flight_, firmware, world);
        s.mission = mission;
        s.completed = completed;
        if (const auto imu = recorder_.imuSamples()) s.setSamples(*imu);
        return s;
    }

    const Waypoints items_;
    const LocalFrame frame_;
    const Plan plan_;
    Board& board_;
    ScriptedFlight flight_;
    Link usb_;
    Recorder recorder_;
    uint64_t step_ = 0;

private:
    const uint64_t step_us_;
};

// A Flight has fly(), true when all was well, and summary(firmware, world). It is made of the board
// and what else is given.
template <class Flight, class... Rest>
int flyAndCheck(const std::string& firmware, const WorldOptions& world,
                const std::filesystem::path& out, const std::filesystem::path& minutes,
                const Rest&... rest) {
    emptyFolder(out);
    std::unique_ptr<Board> board;
    if (firmware == "native")
        board = std::make_unique<NativeBoard>(world);
    else
        board = std::make_unique<AvrBoard>(firmware, world);
    WatchedBoard watched(std::move(board));
    Flight flight(watched, rest...);
    const bool passed = flight.fly() && watched.held();
    writeOutcome(out, minutes, flight.summary(firmware, world));
    return passed ? 0 : 1;
}

}  // namespace simulator
