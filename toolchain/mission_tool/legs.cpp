// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/legs.hpp"

#include "firmware/state/parameters.hpp"
#include "geo/position.hpp"

namespace mission_tool {
namespace {

constexpr uint8_t kReturn = 0x14, kSetHome = 0xB3, kResetHome = 0x42;

geo::Position placeOf(const Entry& entry) { return {entry.record.p3, entry.record.p4}; }

}  // namespace

std::vector<Leg> legsOf(const Document& document) {
    std::vector<Leg> legs(document.entries.size());
    const geo::Position home = placeOf(document.entries[0]);
    const bool home_known = onEarth(document.entries[0].record);
    geo::Position from = home;
    bool about = true, from_known = home_known;
    for (size_t i = 1; i < legs.size(); ++i) {
        const Entry& entry = document.entries[i];
        if (!entry.is(mission::Class::nav)) continue;
        const bool returns = entry.record.id == kReturn;
        if ((!hasPlace(entry) && !returns) || (returns && !home_known)) {  // TAKEOFF, or "here"
            about = true;
            continue;
        }
        const geo::Position to = returns ? home : placeOf(entry);
        if (from_known)
            legs[i] = {true, about, geo::distance_m(from, to), geo::bearing_cd(from, to)};
        from = to;
        from_known = true;
        about = false;
    }
    return legs;
}

bool onEarth(const mission::Record& record) {
    constexpr int32_t kPole_e7 = 900000000, kHalfTurn_e7 = 1800000000;
    return record.p3 >= -kPole_e7 && record.p3 <= kPole_e7 && record.p4 >= -kHalfTurn_e7 &&
           record.p4 <= kHalfTurn_e7;
}

bool aboveHome(const Document& document, size_t index) {
    const mission::Record& record = document.entries[index].record;
    if (index == 0) return false;
    if (document.set == mission::Set::apm1)
        return record.id != kResetHome && firmware::state::parameters.altitude_absolute == 0;
    return record.id != kSetHome && (record.options & mission::kRelativeAltitude) != 0;
}

}  // namespace mission_tool
