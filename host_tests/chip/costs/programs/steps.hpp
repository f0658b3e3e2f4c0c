// SPDX-License-Identifier: GPL-3.0-or-later
// What the programs of this folder time, each between its mark and the end's. costs.cpp reads it.
#pragma once
#include <stdint.h>

namespace costs {

enum Step : uint8_t {
    kNothing = 0x50,  // two marks
    kDistance,
    kBearing,
    kOffset,
    kTrack,
    kPassed,
    kNewBand,
    kNaiveDistance,
    kNaiveBearing,
    kNaiveOffset,
    kNaiveTrack,
    kNaivePassed,
    kIdlePoll,
    kAdvance,
    kHeavyStep,
    kUploadItem,
};

}  // namespace costs
