// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/chronicle.hpp"

#include <algorithm>

#include "simulator/live/failsafe_texts.hpp"

namespace simulator::live {

constexpr int kWarning = 4, kCritical = 2;  // MAV_SEVERITY

void Chronicle::add(const ChronicleEvent& event) {
    events_.push_back(event);
    on_event(event);
}

bool Chronicle::lasts(const std::string& kind, const std::string& name) const {
    return std::any_of(bands_.begin(), bands_.end(), [&](const Band& band) {
        return !band.to_s && band.kind == kind && band.name == name;
    });
}

void Chronicle::begin(const std::string& kind, const std::string& name, double now_s) {
    if (lasts(kind, name)) return;
    bands_.push_back({kind, name, now_s});
    on_band(bands_.back());
}

void Chronicle::end(const std::string& kind, const std::string& name, double now_s) {
    for (Band& band : bands_) {
        if (band.to_s || band.kind != kind || (!name.empty() && band.name != name)) continue;
        band.to_s = now_s;
        on_band(band);
    }
}

void Chronicle::text(const std::string& text, int severity, double now_s) {
    for (const FailsafeText& each : failsafeTexts())
        for (const char* over : each.over)
            if (text == over) end("failsafe", each.begins, now_s);
    if (!failsafeBegunBy(text)) return add({now_s, "text", text, severity});
    begin("failsafe", text, now_s);
    add({now_s, "failsafe", text, severity});
}

void Chronicle::look(const Telemetry& telemetry, World& world, double now_s) {
    lookAtMode(telemetry, now_s);
    lookAtArming(telemetry, now_s);
    lookAtItems(telemetry, now_s);
    lookAtFaults(world, now_s);
    if (world.truth().crashed && !crashed_) add({now_s, "error", "crashed", kCritical});
    crashed_ = world.truth().crashed;
}

void Chronicle::lookAtMode(const Telemetry& telemetry, double now_s) {
    if (!telemetry.heard() || mode_ == telemetry.mode()) return;
    mode_ = telemetry.mode();
    end("mode", "", now_s);
    begin("mode", modeName(*mode_), now_s);
    add({now_s, "mode", modeName(*mode_)});
}

void Chronicle::lookAtArming(const Telemetry& telemetry, double now_s) {
    if (telemetry.armed() == armed_) return;
    armed_ = telemetry.armed();
    if (!armed_) end("failsafe", "", now_s);
    add({now_s, "armed", armed_ ? "armed" : "disarmed"});
}

void Chronicle::lookAtItems(const Telemetry& telemetry, double now_s) {
    for (; reached_ < telemetry.reached.size(); ++reached_)
        add({now_s, "item", "reached item " + std::to_string(telemetry.reached[reached_])});
    for (; visited_ < telemetry.visited.size(); ++visited_)
        add({now_s, "item", "flies item " + std::to_string(telemetry.visited[visited_])});
}

void Chronicle::lookAtFaults(World& world, double now_s) {
    std::vector<std::string> now;
    for (const Fault& fault : world.faults())
        if (now_s >= fault.from_s && now_s < fault.to_s) now.push_back(faultName(fault));
    if (now == failing_) return;
    const auto has = [](const std::vector<std::string>& all, const std::string& one) {
        return std::find(all.begin(), all.end(), one) != all.end();
    };
    for (const std::string& each : failing_) {
        if (has(now, each)) continue;
        end("fault", each, now_s);
        add({now_s, "fault", each + " is over", kWarning});
    }
    for (const std::string& each : now) {
        if (has(failing_, each)) continue;
        begin("fault", each, now_s);
        add({now_s, "fault", each, kWarning});
    }
    failing_ = std::move(now);
}

}  // namespace simulator::live
