// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/guidance/demand.hpp"
#include "core/based.hpp"

#include "firmware/guidance/path_state.hpp"

namespace firmware {
namespace guidance {

using namespace state;

// Who asks sets many of its fields.
PathDemand& beginPath() {
    path_demand.new_path = true;
    return core::based(path_demand);
}

PathDemand& changePath() { return core::based(path_demand); }

}  // namespace guidance
}  // namespace firmware
