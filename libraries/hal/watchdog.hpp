// SPDX-License-Identifier: GPL-3.0-or-later
// The watchdog, and why this run began. The chip's own flags are a hint, for a bootloader may clear
// them: what ends a run knowingly leaves a note in memory that survives.
#pragma once
#include <stdint.h>

namespace hal {

// fault: an interrupt nobody handles; asked: by reboot(); unknown: nobody has left anything, which
// is how a reset button looks behind a bootloader.
enum class ResetCause : uint8_t { power_on, external, brown_out, watchdog, unknown, fault, asked };

struct LastRun {
    ResetCause ended;   // why
    uint8_t trace;      // the last value (trace.hpp), for a reset by the watchdog and a fault
    uint16_t ended_ms;  // likewise: now_ms() then, its lower half
    // Likewise: from its end to the application's first instruction. After any other reset that is
    // the time of the bootloader, which nothing measures.
    uint8_t restart_ms;
};
const LastRun& lastRun();
inline ResetCause resetCause() { return lastRun().ended; }

void watchdogStart();  // begins anew when not fed for 125 ms
void watchdogFeed();
[[noreturn]] void reboot();  // past a bootloader that would wait

}  // namespace hal
