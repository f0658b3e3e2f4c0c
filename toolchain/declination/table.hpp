// SPDX-License-Identifier: GPL-3.0-or-later
// The firmware's table of declinations, as the text of its header.
#pragma once
#include <string>

#include "toolchain/declination/model.hpp"

namespace declination {

constexpr double kTableYear = 2027.5;  // the middle of the model's years

std::string tableHeader(const Model& model);

}  // namespace declination
