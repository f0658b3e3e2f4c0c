// SPDX-License-Identifier: GPL-3.0-or-later
// The pages that show flights and campaigns: one file each that opens offline (docs/page.md).
#pragma once
#include <string>

#include "simulator/report/flight_document.hpp"

namespace simulator {

std::string flightPage(const FlightDocument& document);
std::string livePage();                               // of a server, which gives it the flight
std::string campaignPageOf(const std::string& json);  // with this campaign document

}  // namespace simulator
