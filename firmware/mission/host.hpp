// SPDX-License-Identifier: GPL-3.0-or-later
// What a mission asks of the rooms above it; app/mission_host.cpp fills it in.
#pragma once
#include <stdint.h>

#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace mission {

constexpr uint8_t kNoItem = 0xFF;

struct Host {
    bool (*enterMode)(state::Mode mode);  // false: it cannot be entered now, the reason reported
    void (*disarmAfterLanding)();
    bool (*enableFence)(uint16_t how);  // as DO_FENCE_ENABLE; false: not possible
    bool (*resumesFlight)();            // this run goes on with a flight after a restart
    bool (*memorySurvived)();           // what ended the last run left memory as it was
    void (*logCommand)(uint8_t index);  // kNoItem: that a list is another one
    bool (*logParameter)(uint8_t row);  // false: no room now
    bool (*sendParameter)(uint8_t link, uint16_t index);  // false: no room now
};
extern const Host host;

}  // namespace mission
}  // namespace firmware
