// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/termination.hpp"

#include "firmware/actuators/outputs.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/safety/arming.hpp"
#include "firmware/state/parameters.hpp"

namespace firmware {
namespace safety {

using namespace notify;
using namespace state;

bool terminateFlight() {
    constexpr int8_t kTerminate = 42;
    if (parameters.termination_action != kTerminate) {
        sendStatusText(Severity::warning, STATUS_TEXT("Terminate refused: AFS_TERM_ACTION"));
        return false;
    }
    disarmForGood();
    actuators::holdSurfacesAtEnds();
    sendStatusText(Severity::emergency, STATUS_TEXT("Flight terminated"));
    return true;
}

}  // namespace safety
}  // namespace firmware
