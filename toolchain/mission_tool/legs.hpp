// SPDX-License-Identifier: GPL-3.0-or-later
// The legs of a mission flown in the order in which it is written.
#pragma once
#include <vector>

#include "toolchain/mission_tool/document.hpp"

namespace mission_tool {

struct Leg {
    bool known = false;
    bool about = false;  // it begins at the airplane: taken from where that was last known to be
    float length_m = 0;
    int32_t bearing_cd = 0;
};
std::vector<Leg> legsOf(const Document& document);  // an entry an item

// Item 0 may be anything, refused or not a place at all.
bool onEarth(const mission::Record& record);

// What the altitude of item `index` is measured from; else the sea.
bool aboveHome(const Document& document, size_t index);

}  // namespace mission_tool
