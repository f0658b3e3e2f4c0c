// SPDX-License-Identifier: GPL-3.0-or-later
// What natively compiled firmware weighs on the chip, where that is known.
#pragma once
#include <filesystem>
#include <optional>

#include "simulator/machine/image.hpp"

namespace simulator {

// The image, unless it is absent or a source of the firmware in the folder `root` is newer: then it
// is that of another firmware.
std::optional<Image> imageOfSources(const std::filesystem::path& image,
                                    const std::filesystem::path& root);

}  // namespace simulator
