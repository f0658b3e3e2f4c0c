// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/guidance/demand.hpp"

#include "firmware/guidance/path_state.hpp"

namespace firmware {
namespace guidance {

using namespace state;

void demandPath(const PathDemand& demand) {
    path_demand = demand;
    path_demand.new_path = true;
}

void changeDemand(const PathDemand& demand) { path_demand = demand; }

}  // namespace guidance
}  // namespace firmware
