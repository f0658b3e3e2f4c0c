// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/mission/host.hpp"

#include "firmware/gcs/link.hpp"
#include "firmware/gcs/parameter_transfer.hpp"
#include "firmware/logger/log.hpp"
#include "firmware/modes/modes.hpp"
#include "firmware/safety/arming.hpp"
#include "firmware/safety/fence.hpp"
#include "firmware/safety/restart.hpp"

namespace firmware {
namespace mission {
namespace {

bool enterMode(state::Mode mode) { return modes::requestMode(mode, modes::ModeReason::mission); }

void disarmAfterLanding() { (void)safety::disarm(safety::ArmReason::landed, false); }

bool sendParameter(uint8_t link, uint16_t index) {
    return gcs::parameterSend(gcs::links[link], index);
}

}  // namespace

const Host host = {enterMode,
                   disarmAfterLanding,
                   safety::fenceEnable,
                   safety::flyingOn,
                   safety::memorySurvived,
                   logger::logCommand,
                   logger::logParameter,
                   sendParameter};

}  // namespace mission
}  // namespace firmware
