// SPDX-License-Identifier: GPL-3.0-or-later
// Rests until work comes, from the one interrupt that the test raises.
#include "report.hpp"

static volatile bool work;

namespace hal {
bool imuDataReady() {
    work = true;
    return true;
}
}  // namespace hal

static bool workWaits() { return work; }

int main() {
    board::start();
    uint16_t done = 0;
    for (;;) {
        if (work) {
            work = false;
            report(1, ++done);
        }
        hal::idle(workWaits);
    }
}
