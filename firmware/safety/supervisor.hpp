// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the watchdog may be fed: while frames come, and every tier of the schedule has run
// something within its time.
#pragma once
#include <stdint.h>

#include "core/rom.hpp"
#include "scheduler/scheduler.hpp"

namespace firmware {
namespace safety {

// Frames that the fast, medium and slow tier may be silent. A tier that is only put off runs
// something sooner; firmware/app/tasks.cpp proves it of its table.
constexpr uint8_t kMaxSilent[] ROM = {2, 20, 50};
constexpr uint8_t maxSilent(scheduler::Tier tier) { return kMaxSilent[static_cast<uint8_t>(tier)]; }

class Supervisor {
public:
    // After each frame: the tiers that were served in it (scheduler::bitOf).
    bool wellAfter(uint8_t served) {
        bool well = true;
        for (uint8_t tier = 0; tier < core::count(kMaxSilent); ++tier, served >>= 1) {
            uint8_t& frames = silent_[tier];
            if (served & 1)
                frames = 0;
            else if (frames != 0xFF)
                ++frames;
            if (frames > core::romRead(kMaxSilent[tier])) well = false;
        }
        return well;
    }

private:
    uint8_t silent_[core::count(kMaxSilent)] = {};  // frames
};

}  // namespace safety
}  // namespace firmware
