// SPDX-License-Identifier: GPL-3.0-or-later
// The series of a live flight: what they are called, and their values of a moment.
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "simulator/board.hpp"
#include "simulator/ground/telemetry.hpp"

namespace simulator::live {

using Json = nlohmann::ordered_json;

// The "series" of a flight document without values.
Json seriesJson();

// {"time_s": ..., "values": {NAME or NAME:KIND: number or null}}: of the truth NAME, of others with
// their kind behind it. What is not known is null.
std::string sampleJson(Board& board, const Telemetry& telemetry);

}  // namespace simulator::live
