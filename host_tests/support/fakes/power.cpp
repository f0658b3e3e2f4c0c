// SPDX-License-Identifier: GPL-3.0-or-later
#include "fakes/power.hpp"

#include "fakes/clock.hpp"

namespace fakes {
namespace {
uint32_t writes_left = UINT32_MAX;
uint64_t cut_us = UINT64_MAX;
uint32_t torn = 0;
}  // namespace

void cutPowerAfter(uint32_t writes) { writes_left = writes; }
bool powerWasCut() { return cut_us != UINT64_MAX; }
uint64_t powerCut_us() { return cut_us; }

void restorePower() {
    writes_left = UINT32_MAX;
    cut_us = UINT64_MAX;
}

void tearWrites(uint32_t seed) { torn = seed; }
bool tearsWrites() { return torn != 0; }
uint32_t tornNoise() {
    torn = torn * 1664525u + 1013904223u;
    torn += torn == 0;
    return torn >> 8;
}

Fate beginWrite() {
    if (powerWasCut()) return Fate::lost;
    if (writes_left == UINT32_MAX) return Fate::done;
    if (writes_left-- > 0) return Fate::done;
    cut_us = time_us();
    return Fate::damaged;
}

}  // namespace fakes
