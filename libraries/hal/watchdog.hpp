// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <stdint.h>

namespace hal {

enum class ResetCause : uint8_t { power_on, external, brown_out, watchdog, unknown };

ResetCause resetCause();  // of the reset this run began with
void watchdogStart();     // resets the chip when not fed for 250 ms
void watchdogFeed();
[[noreturn]] void reboot();  // past a bootloader that would wait

}  // namespace hal
