// SPDX-License-Identifier: GPL-3.0-or-later
// The page that GET / answers with.
#pragma once
#include <string_view>

namespace simulator::live {

std::string_view livePage();

}  // namespace simulator::live
