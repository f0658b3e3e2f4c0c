// SPDX-License-Identifier: GPL-3.0-or-later
// The smaller doubles: analogue inputs, receiver, servos, watchdog, marks, interrupt lock.
#pragma once
#include <stdint.h>

#include <array>
#include <exception>
#include <vector>

#include "hal/analog.hpp"
#include "hal/rc_input.hpp"
#include "hal/servo_output.hpp"
#include "hal/watchdog.hpp"

namespace fakes {

// One input as the next analogTake finds it. `every_scan`: each analogScan puts this sum there
// anew, as a steady voltage would.
void setAnalog(hal::Analog input, uint16_t reading, uint8_t count = 1, bool every_scan = true);
uint32_t analogScans();

// A whole frame from the receiver, now. Channels not named are 0.
void receiveRc(const std::vector<uint16_t>& pulse_us);
// One with an edge too many or too few.
void receiveBrokenRc(const std::vector<uint16_t>& pulse_us);

struct Servos {
    uint16_t rate_hz = 0;                               // 0: not started
    std::array<uint16_t, hal::kServos> pulse_halfus{};  // 0: silent
    uint32_t writes = 0;
};
Servos& servos();

struct Watchdog {
    hal::LastRun last_run = {hal::ResetCause::power_on, 0, 0, 0};
    bool started = false;
    uint32_t feeds = 0;
    uint64_t fed_us = 0;
    uint64_t guarded_us = 0;  // when the hang timer was last reset
};
Watchdog& watchdog();
struct Rebooted : std::exception {};  // thrown by hal::reboot

std::vector<uint8_t>& marks();
int interruptLocks();  // how deep hal::Locked is nested now

void resetIo();

}  // namespace fakes
