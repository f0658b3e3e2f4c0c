// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/guidance/demand.hpp"

#include "firmware/guidance/path_state.hpp"

namespace firmware {
namespace guidance {

using namespace state;

PathDemand& beginPath() {
    path_demand.new_path = true;
    return path_demand;
}

PathDemand& changePath() { return path_demand; }

}  // namespace guidance
}  // namespace firmware
