// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/chaos/shrink.hpp"

#include <algorithm>

namespace simulator::chaos {
namespace {

class Shrinker {
public:
    Shrinker(Scenario scenario, const Fails& fails, unsigned most_tries)
        : best_(std::move(scenario)), fails_(fails), tries_(most_tries) {}

    Scenario run() {
        shortenTime();
        leaveOutEvents();
        leaveOutItems();
        leaveOutZones();
        calm();
        makeUsual();
        leaveOutEvents();
        shortenTime();
        return best_;
    }

private:
    bool better(const Scenario& candidate) {
        if (tries_ == 0) return false;
        --tries_;
        if (!fails_(candidate)) return false;
        best_ = candidate;
        return true;
    }

    // Events by halves, quarters, ... until no single one can be left out.
    void leaveOutEvents() {
        for (size_t size = std::max<size_t>(best_.events.size() / 2, 1);; size /= 2) {
            bool cut = true;
            while (cut && !best_.events.empty()) {
                cut = false;
                for (size_t at = 0; at < best_.events.size();) {
                    Scenario candidate = best_;
                    const auto from = candidate.events.begin() + static_cast<long>(at);
                    const size_t count = std::min(size, candidate.events.size() - at);
                    candidate.events.erase(from, from + static_cast<long>(count));
                    if (better(candidate))
                        cut = true;
                    else
                        at += size;
                }
                if (size > 1) break;
            }
            if (size <= 1) return;
        }
    }

    // Home, the take-off and the landing stay.
    void leaveOutItems() {
        for (size_t at = best_.mission.size(); at-- > 2;) {
            if (at + 1 >= best_.mission.size()) continue;
            Scenario candidate = best_;
            candidate.mission.erase(candidate.mission.begin() + static_cast<long>(at));
            for (size_t i = 0; i < candidate.mission.size(); ++i)
                candidate.mission[i].index = static_cast<int>(i);
            better(candidate);
        }
    }

    void leaveOutZones() {
        for (size_t at = best_.fence.areas.size(); at-- > 0;) {
            Scenario candidate = best_;
            candidate.fence.areas.erase(candidate.fence.areas.begin() + static_cast<long>(at));
            if (candidate.fence.areas.empty()) candidate.fence = {};
            better(candidate);
        }
    }

    void calm() {
        if (best_.wind_mps <= 0 && !best_.gusts) return;
        Scenario candidate = best_;
        candidate.wind_mps = candidate.wind_from_deg = 0;
        candidate.gusts = false;
        better(candidate);
    }

    void makeUsual() {
        const Conditions usual;
        for (const Condition& each : kConditions) {
            Scenario candidate = best_;
            double& value = candidate.conditions.*each.value;
            if (each.of_the_place || value == usual.*each.value) continue;
            value = usual.*each.value;
            better(candidate);
        }
    }

    // To a second.
    void shortenTime() {
        double fails_s = best_.seconds, holds_s = 0;
        while (fails_s - holds_s > 1 && tries_ > 0) {
            Scenario candidate = best_;
            candidate.seconds = (fails_s + holds_s) / 2;
            const double end_s = candidate.seconds;
            candidate.events.erase(
                std::remove_if(candidate.events.begin(), candidate.events.end(),
                               [end_s](const Event& event) { return event.at_s > end_s; }),
                candidate.events.end());
            (better(candidate) ? fails_s : holds_s) = candidate.seconds;
        }
    }

    Scenario best_;
    const Fails& fails_;
    unsigned tries_;
};

}  // namespace

Scenario shrink(Scenario scenario, const Fails& fails, unsigned most_tries) {
    return Shrinker(std::move(scenario), fails, most_tries).run();
}

}  // namespace simulator::chaos
