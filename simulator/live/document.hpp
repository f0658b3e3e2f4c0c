// SPDX-License-Identifier: GPL-3.0-or-later
// The flight document of a live flight, version 1: everything but the samples.
#pragma once
#include "simulator/live/chronicle.hpp"
#include "simulator/live/plan_download.hpp"
#include "simulator/live/samples.hpp"

namespace simulator::live {

// What is known of where the flight comes from.
struct Origin {
    std::string title = "Live flight", provenance = "{}";  // JSON of report/provenance.hpp
    Truth start{};                                         // where the airplane stood
};

Json eventJson(const ChronicleEvent& event);
Json bandJson(const Band& band);
// Mission, fence and rally points as the board holds them. Home is `start` while it has none.
Json planJson(const PlanDownload& plans, const Truth& start);

std::string documentJson(const Origin& origin, const PlanDownload& plans,
                         const Chronicle& chronicle);

// As JSON, with bytes that are no UTF-8 replaced: texts come from outside.
std::string dumped(const Json& json);

}  // namespace simulator::live
