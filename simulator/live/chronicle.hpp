// SPDX-License-Identifier: GPL-3.0-or-later
// What happens in a flight, as the page shows it: events, and bands of modes, failsafes and faults,
// from what the autopilot reports and from the simulator's truth.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "simulator/ground/telemetry.hpp"
#include "simulator/world.hpp"

namespace simulator::live {

// The names of the flight document.
struct ChronicleEvent {
    double time_s;
    std::string kind, text;
    std::optional<int> severity = {};  // MAV_SEVERITY
};
struct Band {
    std::string kind, name;
    double from_s;
    std::optional<double> to_s = {};  // empty: it lasts
};

class Chronicle {
public:
    // After each step: what has changed since the last one.
    void look(const Telemetry& telemetry, World& world, double now_s);
    void text(const std::string& text, int severity, double now_s);
    void add(const ChronicleEvent& event);

    const std::vector<ChronicleEvent>& events() const { return events_; }
    const std::vector<Band>& bands() const { return bands_; }

    // Called with each event, and with each band when it begins and when it ends.
    std::function<void(const ChronicleEvent&)> on_event = [](const ChronicleEvent&) {};
    std::function<void(const Band&)> on_band = [](const Band&) {};

private:
    void lookAtMode(const Telemetry& telemetry, double now_s);
    void lookAtArming(const Telemetry& telemetry, double now_s);
    void lookAtItems(const Telemetry& telemetry, double now_s);
    void lookAtFaults(World& world, double now_s);
    void begin(const std::string& kind, const std::string& name, double now_s);
    void end(const std::string& kind, const std::string& name, double now_s);  // "": all of a kind
    bool lasts(const std::string& kind, const std::string& name) const;

    std::vector<ChronicleEvent> events_;
    std::vector<Band> bands_;
    std::optional<uint32_t> mode_;
    bool armed_ = false, crashed_ = false;
    size_t reached_ = 0, visited_ = 0;
    std::vector<std::string> failing_;
};

}  // namespace simulator::live
