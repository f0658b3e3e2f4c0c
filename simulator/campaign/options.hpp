// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of the campaign program.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "simulator/campaign/flight.hpp"

namespace simulator {

struct CampaignOptions {
    std::vector<std::string> missions, airplanes;
    std::vector<CampaignWind> winds;
    uint64_t first_seed = 1, last_seed = 10;
    bool drawn = false;  // worlds by the seeds, instead of airplanes, missions and winds
    unsigned jobs = 1;
    std::string out;
};

// The options, or the status to end with: 0 after --help, 2 after one line about what is wrong.
struct ParsedCampaign {
    CampaignOptions options;
    std::optional<int> exit_status;
};
ParsedCampaign parseCampaignOptions(int count, char** words);

std::vector<CampaignFlight> flightsOf(const CampaignOptions& options);

}  // namespace simulator
