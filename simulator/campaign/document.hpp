// SPDX-License-Identifier: GPL-3.0-or-later
// A campaign as a document, which campaign.json is and campaign.html shows: every flight with its
// figures, and what they are held against (docs/campaign_document.md).
#pragma once
#include <string>
#include <vector>

#include "simulator/campaign/flight.hpp"

namespace simulator {

// "240 flights, 2 failed", or that it was interrupted and how far it came.
std::string flownText(size_t flown, size_t planned, size_t failed);

// Of flights in drawn worlds when the first one is. `wall_s`: how long they took.
std::string campaignJson(const std::vector<CampaignResult>& results, size_t planned, double wall_s);
std::string campaignPage(const std::vector<CampaignResult>& results, size_t planned, double wall_s);

}  // namespace simulator
