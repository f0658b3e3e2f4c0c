// SPDX-License-Identifier: GPL-3.0-or-later
// One flight of a campaign: what is flown, how it is flown again, what came of it. Every flight is
// a run of the fly program, so that one that dies takes no other with it; one in a drawn world is a
// run of the program that draws it, flies AUTOTUNE, and then becomes the fly program.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace simulator {

struct CampaignWind {
    double mps = 0, from_deg = 0;  // with gusts where it blows at all

    bool calm() const { return mps <= 0; }
    std::string name() const;  // as on the command line: "calm" or "5,320"
};

struct CampaignFlight {
    std::string airplane, mission;
    CampaignWind wind;
    uint64_t seed = 1;
    bool drawn = false;  // airplane, mission and wind by the seed

    std::string missionName() const;  // without folder and ending
    std::string airplaneName() const;
    std::string group() const;  // all but the seed
    std::vector<std::string> arguments() const;
    // The command line that flies it again; of a drawn world natively alone, as AUTOTUNE comes
    // first.
    std::string replay(bool native) const;
};

struct WorldValue {  // of a drawn world
    std::string key, name, unit;
    double value = 0;
};

struct CampaignResult {
    CampaignFlight flight;
    bool flown = false;   // to its end; false: it was interrupted, or never begun
    std::string failure;  // one line; empty: all is well
    std::map<std::string, double> figures;
    double emulated_s = 0;
    // past the landing point along the last leg and right of it, in m
    std::optional<std::pair<double, double>> touchdown;
    std::vector<WorldValue> world = {};
    std::string report = {};  // from the folder of the campaign; empty: there is none
};

struct CampaignPrograms {
    std::string fly, drawn;
};

// Flies it in `folder`, which afterwards holds summary.json, fly.log and report.html; in a drawn
// world also the files of that world.
CampaignResult flyOne(const CampaignPrograms& programs, const CampaignFlight& flight,
                      const std::string& folder);

// What drawn.json says of a drawn world; nothing when it is no such file.
std::vector<WorldValue> worldValuesOf(const std::string& drawn_json);

// What the summary says of the flight, on its own.
CampaignResult resultOf(const CampaignFlight& flight, const std::string& summary_json);

}  // namespace simulator
