// SPDX-License-Identifier: GPL-3.0-or-later
// Flights of chaos as a campaign document (docs/campaign_document.md), which campaign.json is and
// campaign.html shows.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "simulator/chaos/totals.hpp"

namespace simulator::chaos {

// One flight, as far as the document lists it.
struct FlownScenario {
    uint64_t seed = 0;
    std::string airplane;
    double wind_mps = 0;
    bool gusts = false, must_survive = false;
    std::map<std::string, unsigned> events;
    Outcome outcome;
    std::string file;  // of the least scenario that violates, from the folder of the document
};
FlownScenario flownScenario(uint64_t seed, const Scenario& scenario, const Outcome& outcome);

struct ChaosRun {
    uint64_t planned = 0;
    std::string firmware;  // as shown
    std::string option;    // that chooses it: " --elf"; empty: natively compiled
    std::string folder;    // of the document, as it is typed
    double wall_s = 0;
};

// `flights`: those that are listed, which may be fewer than those of the totals.
std::string chaosJson(const ChaosRun& run, const Totals& totals,
                      const std::vector<FlownScenario>& flights);
std::string chaosPage(const ChaosRun& run, const Totals& totals,
                      const std::vector<FlownScenario>& flights);

}  // namespace simulator::chaos
