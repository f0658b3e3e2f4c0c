// SPDX-License-Identifier: GPL-3.0-or-later
// A drawn world as the files that the fly program reads.
#pragma once
#include <filesystem>

#include "simulator/drawn/draw.hpp"

namespace simulator::drawn {

struct DrawnFiles {
    explicit DrawnFiles(const std::filesystem::path& folder)
        : airplane(folder / "airplane.json"),
          owner(folder / "owner.param"),
          tuned(folder / "tuned.param"),
          world(folder / "world.json"),
          mission(folder / "mission.waypoints"),
          drawn(folder / "drawn.json") {}

    std::filesystem::path airplane, owner, tuned, world, mission, drawn;
};

// All but `tuned`. Throws OutputError.
void writeFiles(const DrawnFiles& files, const DrawnWorld& drawn);
void writeParameters(const std::filesystem::path& path, const std::string& about,
                     const ParameterSettings& settings);

}  // namespace simulator::drawn
