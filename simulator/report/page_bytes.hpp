// SPDX-License-Identifier: GPL-3.0-or-later
// The pages that web/build.mjs has made, as they are inside this program.
#pragma once
#include <string_view>

namespace simulator {

std::string_view flightPageTemplate();
std::string_view campaignPageTemplate();

}  // namespace simulator
