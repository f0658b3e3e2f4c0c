// SPDX-License-Identifier: GPL-3.0-or-later
// The flight document, version 1: what the page of a flight shows, whether simulated, logged or
// live. docs/flight_document.md describes it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "simulator/report/provenance.hpp"

namespace simulator {

struct DocumentPlace {
    double latitude_deg = 0, longitude_deg = 0;
    std::optional<double> altitude_m;
};

struct DocumentItem {
    int index = 0;
    std::string name, text;
    std::optional<DocumentPlace> place;
    std::optional<double> radius_m;  // of a circle
};

struct DocumentZone {
    bool keeps_in = true;            // else it is to be stayed out of
    std::vector<DocumentPlace> rim;  // corners; of a circle its centre alone
    std::optional<double> radius_m;  // of a circle
};

struct DocumentPlan {
    std::optional<DocumentPlace> home;
    std::vector<DocumentItem> items;
    std::vector<DocumentPlace> fence, rally;
    std::vector<DocumentZone> zones;  // of the fence, but for the polygon in `fence`
};

struct DocumentSeries {
    std::string name, title, unit, group, kind;  // kind may be empty
    size_t time = 0;                             // index into times
    std::vector<double> values;                  // NaN: none
};

struct DocumentEvent {
    double time_s = 0;
    std::string kind, text;
    std::optional<int> severity;  // MAV_SEVERITY
};

struct DocumentBand {
    std::string kind, name;
    double from_s = 0, to_s = 0;
};

struct Deviation {
    std::string name;
    double value = 0;
    std::string unit;
    std::optional<double> goal;  // the most it may be

    bool met() const { return !goal || value <= *goal; }
};

struct DocumentTable {
    std::string title, note;
    std::vector<std::string> heads;
    std::vector<std::vector<std::string>> rows;
};

struct FlightDocument {
    std::string kind, title, verdict;
    bool good = false;
    Provenance provenance;
    DocumentPlan plan;
    std::vector<std::vector<double>> times;  // seconds
    std::vector<DocumentSeries> series;
    std::vector<DocumentEvent> events;
    std::vector<DocumentBand> bands;
    std::vector<Deviation> deviations;
    std::vector<DocumentTable> tables;
};

std::string flightJson(const FlightDocument& document);

}  // namespace simulator
