// SPDX-License-Identifier: GPL-3.0-or-later
// What the fly program reports of a flight, whoever flew it, and the files it leaves behind.
#pragma once
#include <chrono>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "simulator/flight_folder.hpp"
#include "simulator/fly_options.hpp"
#include "simulator/ground/mission_file.hpp"
#include "simulator/invariants/watched_board.hpp"
#include "simulator/machine/board_wiring.hpp"
#include "simulator/output_file.hpp"
#include "simulator/parameter_file.hpp"
#include "simulator/report/recorder.hpp"
#include "simulator/report/summary.hpp"

namespace simulator {

constexpr uint64_t kFrame_us = 10'000, kStep_us = 2 * kFrame_us;
constexpr int kStepsPerSample = 5;

// What the user gave and we cannot use: one line, exit 2.
class WrongInput : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

class WallClock {
public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// The files of a flight: each is tried, whatever became of the others; a line for each that failed.
class Results {
public:
    template <class Write>
    void add(Write write) {
        try {
            write();
        } catch (const OutputError& error) {
            std::cerr << "fly: " << error.what() << "\n";
            all_written_ = false;
        }
    }
    void addFile(const std::filesystem::path& path, const std::string& contents) {
        add([&] { writeFile(path, contents); });
    }
    bool allWritten() const { return all_written_; }

private:
    bool all_written_ = true;
};

const BoardWiring& wiringOf(const FlyOptions& options);
// The invariants are of our firmware: another's words for things may be others.
bool ours(const FlyOptions& options);

// Needs the firmware and the figures of summaryOf(). With the faults and parameters that were set
// in flight.
void takeProvenance(Summary& s, const FlyOptions& options, const ParameterSettings& settings,
                    WatchedBoard& board);

// The name of the mission in report and index.
std::string missionName(const FlyOptions& options);

// What does not depend on who flew it.
Summary summaryOf(const FlyOptions& options, WatchedBoard& board, const Recorder& recorder,
                  const WallClock& clock);
void takeErrors(Summary& s, const Metrics& m, const AttitudeErrors& attitude);
void addTelemetry(Summary& s, const Telemetry& telemetry);
// A flight that violates an invariant was not completed.
void takeViolations(Summary& s, WatchedBoard& board);

// Its files can be written. Throws WrongInput.
std::unique_ptr<FlightFolder> prepareReport(const FlyOptions& options);

// How a served flight ends, of which nothing was to be completed, when nothing went wrong.
constexpr char kServedEnd[] = "served flight: ended";

void writeReport(const FlyOptions& options, const FlightFolder& folder, const Summary& summary,
                 const std::vector<Sample>& samples, const MissionFile& mission, Results& results);

}  // namespace simulator
