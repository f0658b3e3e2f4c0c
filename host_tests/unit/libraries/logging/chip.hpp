// SPDX-License-Identifier: GPL-3.0-or-later
// The DataFlash behind libraries/hal/page_flash.hpp as the log's tests use it: the real driver on
// the simulator's chip, on the fakes' clock.
#pragma once
#include <stdint.h>

#include <memory>

#include "fakes/clock.hpp"
#include "simulator/devices/at45db.hpp"

namespace chip {

void fit(const simulator::At45dbOptions& options = {});  // a blank one, known at once
void restart();                                          // the processor's, with its driver
void cutPower();                                         // and all that
simulator::At45db& model();
uint64_t reads();  // page reads since the fit
void wantByMission(bool wants);

}  // namespace chip
