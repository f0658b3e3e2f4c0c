// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/findings.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/mission/command_table.hpp"
#include "firmware/mission/engine.hpp"
#include "firmware/state/parameters.hpp"
#include "mission/longest_pass.hpp"
#include "toolchain/mission_tool/board.hpp"
#include "toolchain/mission_tool/legs.hpp"

namespace mission_tool {
namespace {

using firmware::mission::kCommandTable;
using firmware::state::parameters;
using mission::Class;
using mission::Set;

constexpr uint8_t kWaypoint = 0x10, kLoiterUnlimited = 0x11, kTakeoff = 0x16, kTarget = 0x17;
constexpr float kFar_m = 50'000;

const Document* read_from;
core::Status readRecord(uint8_t index, uint8_t* to) {
    mission::pack(read_from->set, read_from->entries[index].record, to);
    return core::Status::ok;
}

// The firmware's own look at a mission.
firmware::mission::MissionSummary summaryOf(const Document& document) {
    read_from = &document;
    firmware::mission::MissionSummary summary = {};
    const auto count = static_cast<uint8_t>(std::min(document.entries.size(), kMaxItems));
    while (count > 1 && firmware::mission::summarizeStep(summary, document.set, count, readRecord) ==
                            core::Status::busy) {
    }
    return summary;
}

std::string metres(float length_m) { return std::to_string(static_cast<int>(length_m)) + " m"; }

std::string items(size_t first, size_t last) {
    return first == last ? "item " + std::to_string(first)
                         : "items " + std::to_string(first) + " to " + std::to_string(last);
}

class Inspection {
public:
    explicit Inspection(const Document& document)
        : document_(document), summary_(summaryOf(document)), accompanied_(accompaniedNavs(document)) {}

    std::vector<Finding> all() {
        const size_t count = document_.entries.size();
        for (size_t i = 0; i < count; ++i) {
            refusal(i);
            for (const std::string& note : document_.entries[i].notes) warn(i, note);
            if (i == 0 || !document_.entries[i].good()) continue;
            if (document_.entries[i].is(Class::jump)) jump(i);
            if (document_.entries[i].is(Class::nav)) nav(i);
        }
        whole(count);
        passes();
        legs();
        std::stable_sort(found_.begin(), found_.end(),
                         [](const Finding& a, const Finding& b) { return a.index < b.index; });
        return found_;
    }

private:
    void warn(size_t index, const std::string& text) { found_.push_back({false, index, text}); }
    void refuse(size_t index, const std::string& text) { found_.push_back({true, index, text}); }

    size_t target(const Entry& entry) const {
        if (entry.record.id == 0x31) return 1;  // RESET_INDEX
        const int32_t p2 = document_.set == Set::apm1 ? entry.record.p2 : 0;
        return static_cast<size_t>(p2 != 0 ? p2 : entry.record.p1);
    }

    void refusal(size_t i) {
        const Entry& entry = document_.entries[i];
        if (entry.good()) return;
        const bool jumps =
            entry.row != mission::kNoRow && kCommandTable.kind(entry.row) == Class::jump;
        refuse(i, entry.problem +
                      (i > 0 && jumps && target(entry) == i ? ": it jumps to itself" : ""));
    }

    void jump(size_t i) {
        if (document_.set == Set::apm2 && target(document_.entries[i]) > summary_.last_nav)
            warn(i, "no NAV follows item " + std::to_string(target(document_.entries[i])) +
                        ": this jump ends the mission");
    }

    void nav(size_t i) {
        const Entry& entry = document_.entries[i];
        const bool climbs = entry.record.id <= 0x13 || entry.record.id >= kTakeoff;
        if (climbs && aboveHome(document_, i) && entry.record.p2 <= 0)
            warn(i, "its altitude is not above home");
        if (last_land_ != 0 && (kCommandTable.traits(entry.row) & mission::kBeginsFlight) == 0)
            warn(i, "never flown: only a TAKEOFF can follow the LAND of item " +
                        std::to_string(last_land_));
        if (i < summary_.last_nav && entry.record.id == kLoiterUnlimited && !abandoned(i))
            warn(i, "never finishes: what follows is flown only when it is chosen");
        last_land_ = (kCommandTable.traits(entry.row) & mission::kEndsFlight) != 0 ? i : 0;
    }

    // Does a jump beside it take the airplane away? One of the 1.0 set never does.
    bool abandoned(size_t nav) const {
        for (size_t i = 1; document_.set == Set::apm2 && i < nav; ++i)
            if (accompanied_[i] == nav && document_.entries[i].is(Class::jump)) return true;
        return false;
    }

    void whole(size_t count) {
        if (count > kMaxItems)
            refuse(kMaxItems, "expected at most " + std::to_string(kMaxItems) +
                                  " items, home included, found " + std::to_string(count));
        if (summary_.counters > mission::kMaxCounters)
            refuse(0, "expected at most " + std::to_string(mission::kMaxCounters) +
                          " jumps with a count, found " + std::to_string(summary_.counters));
        if (summary_.first_nav == 0) {
            warn(0, "no NAV command: AUTO is refused");
        } else if (document_.set == Set::apm1 && summary_.first_nav > 1) {
            warn(1, items(1, summary_.first_nav - 1u) + " before the first NAV: never run");
        } else if (document_.set == Set::apm2 && summary_.last_run + 1u < count &&
                   parameters.mission_trailing == 0) {
            warn(summary_.last_run + 1u,
                 items(summary_.last_run + 1u, count - 1) +
                     " behind the last NAV: never run while MIS_TRAILING is 0");
        }
    }

    // What may hold up the next NAV for too long, as the board computes it.
    void passes() {
        using mission::LongestPass;
        LongestPass passes;
        passes.begin(document_.set);
        const auto count = static_cast<uint8_t>(std::min(document_.entries.size(), kMaxItems));
        for (uint8_t i = 1; i < count; ++i) {
            const Entry& entry = document_.entries[i];
            if (!entry.good()) return;  // refused
            const Class kind = kCommandTable.kind(entry.row);
            mission::Jump jump = {};
            if (kind == Class::jump) jump = kCommandTable.rows[entry.row].target(entry.record);
            passes.add(i, kind, jump);
        }
        LongestPass::Verdict verdict = LongestPass::Verdict::busy;
        while (verdict == LongestPass::Verdict::busy) verdict = passes.step(count);
        if (verdict == LongestPass::Verdict::goes_round)
            refuse(passes.item(), "jumps go round here with neither NAV nor CONDITION on the way");
        if (verdict == LongestPass::Verdict::too_long)
            refuse(passes.item(), "what is run from here on holds up the next NAV for more than 1.5 s");
        if (verdict == LongestPass::Verdict::too_many)
            refuse(passes.item(), "too many jumps in one pass from here on, or in the mission");
    }

    void legs() {
        const std::vector<Leg> legs = legsOf(document_);
        for (size_t i = 1; i < legs.size(); ++i) {
            if (!legs[i].known) continue;
            const mission::Record& record = document_.entries[i].record;
            const bool has_radius = record.id == kWaypoint || record.id == kTarget;
            const float radius_m =
                record.p1 != 0 ? record.p1 : static_cast<float>(parameters.waypoint_radius_m);
            if (has_radius && !legs[i].about && legs[i].length_m < radius_m)
                warn(i, "the leg of " + metres(legs[i].length_m) +
                            " is shorter than the acceptance radius of " + metres(radius_m));
            if (legs[i].length_m > kFar_m) warn(i, "a leg of " + metres(legs[i].length_m));
        }
    }

    const Document& document_;
    firmware::mission::MissionSummary summary_;
    std::vector<size_t> accompanied_;
    std::vector<Finding> found_;
    size_t last_land_ = 0;
};

}  // namespace

namespace {

// What stands behind the last NAV and before a jump that leads to one accompanies that one.
void closeTheLoop(const Document& document, std::vector<size_t>& navs) {
    const size_t count = document.entries.size();
    const auto isNav = [&](size_t i) { return document.entries[i].is(Class::nav); };
    size_t behind = count;
    while (behind > 1 && !isNav(behind - 1)) --behind;
    for (size_t jump = behind; jump < count; ++jump) {
        const Entry& entry = document.entries[jump];
        if (!entry.is(Class::jump) || !entry.good()) continue;
        size_t nav = entry.record.p1;
        while (nav < behind && !isNav(nav)) ++nav;
        for (size_t i = behind; i <= jump && nav < behind; ++i)
            if (document.entries[i].good()) navs[i] = nav;
        return;
    }
}

}  // namespace

std::vector<size_t> accompaniedNavs(const Document& document) {
    const size_t count = document.entries.size();
    std::vector<size_t> navs(count, 0);
    size_t nav = 0;
    for (size_t n = 1; n < count; ++n) {
        // 1.0: what stands behind a NAV runs beside it; 2.0: what stands before it
        const size_t i = document.set == Set::apm1 ? n : count - n;
        if (document.entries[i].is(Class::nav)) nav = i;
        if (document.entries[i].good()) navs[i] = nav;
    }
    if (document.set == Set::apm2) closeTheLoop(document, navs);
    return navs;
}

std::vector<Finding> findings(const Document& document) { return Inspection(document).all(); }

}  // namespace mission_tool
