// SPDX-License-Identifier: GPL-3.0-or-later
// What a served flight leaves behind, if it was ever armed or the folder was asked for.
#pragma once
#include "simulator/fly_live.hpp"
#include "simulator/fly_report.hpp"

namespace simulator {

class ServedRecord {
public:
    // `items`: the first is where the airplane stands. Throws WrongInput when the report cannot be
    // written.
    ServedRecord(const FlyOptions& options, const Waypoints& items,
                 const ParameterSettings& settings);

    void step(WatchedBoard& board, live::Live& live);  // after each frame
    // `fault`: why it could not go on; empty: somebody ended it.
    void write(WatchedBoard& board, FlyWatchers& watchers, const std::string& fault,
               Results& results);

private:
    void measure(Metrics& metrics, std::vector<Sample>& samples,
                 const live::Station& station) const;

    const FlyOptions& options_;
    const ParameterSettings settings_;
    const std::unique_ptr<FlightFolder> folder_;
    const LocalFrame frame_;
    const Plan no_plan_;
    Recorder recorder_;
    WallClock clock_;
    int steps_ = 0;
    unsigned plans_ = 0;
    size_t plan_since_ = 0;  // the first sample of the plan that the board holds
    bool armed_ = false;
};

}  // namespace simulator
