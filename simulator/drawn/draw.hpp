// SPDX-License-Identifier: GPL-3.0-or-later
// A world by lot: an airplane, its sensors, the air and the field, every one of them within what
// owners of such boards have. The same seed draws the same world.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "simulator/airplane/parameters.hpp"
#include "simulator/ground/parameter_upload.hpp"
#include "simulator/ground/waypoints.hpp"
#include "simulator/world.hpp"

namespace simulator::drawn {

// What of a world its flight may depend on; docs/campaign_document.md lists the keys.
struct DrawnValue {
    const char *key, *name, *unit;
    double value;
};

struct DrawnWorld {
    AirplaneParameters airplane;
    WorldOptions world;       // its place, air and sensors; not the airplane
    ParameterSettings owner;  // what its owner knows and sets
    Waypoints mission;        // a box with a climb, a descent, a loiter and a landing
    Waypoints tuning;         // where AUTOTUNE begins: a take-off and a place to fly to
    std::string about;        // one line
    std::vector<DrawnValue> values;
};

// `magnetic_model` is the file of the World Magnetic Model's coefficients. Throws when it cannot be
// read.
DrawnWorld drawWorld(uint64_t seed, const std::string& magnetic_model);

}  // namespace simulator::drawn
