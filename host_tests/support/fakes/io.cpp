// SPDX-License-Identifier: GPL-3.0-or-later
#include "fakes/io.hpp"

#include <algorithm>
#include <utility>

#include "fakes/clock.hpp"
#include "hal/hang_timer.hpp"
#include "hal/interrupts.hpp"
#include "hal/trace.hpp"

namespace {

struct Input {
    hal::AnalogSum sum;
    uint16_t reading;
    uint8_t count;
    bool every_scan;
};

struct {
    Input inputs[hal::kAnalogs];
    uint32_t scans;
    std::array<uint16_t, hal::kRcChannels> rc, whole_rc;
    bool rc_fresh, rc_ever, rc_whole;
    uint64_t rc_us;
    fakes::Servos servos;
    fakes::Watchdog watchdog;
    std::vector<uint8_t> marks;
    int locks;
} io = {};

void put(Input& input) {
    input.sum.sum = static_cast<uint16_t>(input.sum.sum + input.reading * input.count);
    input.sum.count = static_cast<uint8_t>(input.sum.count + input.count);
}

}  // namespace

namespace fakes {

void setAnalog(hal::Analog input, uint16_t reading, uint8_t count, bool every_scan) {
    Input& now = io.inputs[static_cast<uint8_t>(input)];
    now = {{0, 0}, reading, count, every_scan};
    put(now);
}

uint32_t analogScans() { return io.scans; }

void receiveRc(const std::vector<uint16_t>& pulse_us) {
    receiveBrokenRc(pulse_us);
    io.whole_rc = io.rc;
    io.rc_whole = true;
}

void receiveBrokenRc(const std::vector<uint16_t>& pulse_us) {
    io.rc.fill(0);
    std::copy_n(pulse_us.begin(), std::min(pulse_us.size(), io.rc.size()), io.rc.begin());
    io.rc_fresh = io.rc_ever = true;
    io.rc_us = time_us();
}

Servos& servos() { return io.servos; }
Watchdog& watchdog() { return io.watchdog; }
std::vector<uint8_t>& marks() { return io.marks; }
int interruptLocks() { return io.locks; }
void resetIo() { io = {}; }

}  // namespace fakes

namespace hal {

void analogScan() {
    ++io.scans;
    for (Input& input : io.inputs) {
        if (input.every_scan && input.sum.count < 60) put(input);
    }
}

AnalogSum analogTake(Analog input) {
    Input& now = io.inputs[static_cast<uint8_t>(input)];
    const AnalogSum taken = now.sum;
    now.sum = {0, 0};
    return taken;
}

bool rcRead(uint16_t (&pulse_us)[kRcChannels]) {
    std::copy(io.rc.begin(), io.rc.end(), pulse_us);
    const bool fresh = io.rc_fresh;
    io.rc_fresh = false;
    return fresh;
}

bool rcReadWhole(uint16_t (&pulse_us)[kRcChannels]) {
    std::copy(io.whole_rc.begin(), io.whole_rc.end(), pulse_us);
    return std::exchange(io.rc_whole, false);
}

uint16_t rcPulse_us(uint8_t channel) { return io.rc.at(channel); }

uint32_t rcAge_us() {
    if (!io.rc_ever) return UINT32_MAX;
    return static_cast<uint32_t>(std::min<uint64_t>(fakes::time_us() - io.rc_us, UINT32_MAX));
}

void servoStart(uint16_t rate_hz) {
    io.servos.rate_hz = rate_hz;
    io.servos.pulse_halfus.fill(0);
}

void servoWrite(uint8_t output, uint16_t pulse_halfus) {
    io.servos.pulse_halfus.at(output) = pulse_halfus;
    ++io.servos.writes;
}

uint16_t servoRead(uint8_t output) { return io.servos.pulse_halfus.at(output); }

const LastRun& lastRun() { return io.watchdog.last_run; }
void hangTimerStart() {}
void hangTimerReset() { io.watchdog.guarded_us = fakes::time_us(); }
void watchdogStart() { io.watchdog.started = true; }

void watchdogFeed() {
    ++io.watchdog.feeds;
    io.watchdog.fed_us = fakes::time_us();
}

void reboot() { throw fakes::Rebooted(); }

void trace(uint8_t value) { io.marks.push_back(value); }
void traceItem(uint8_t value, uint8_t) { io.marks.push_back(value); }

uint8_t lockInterrupts() {
    ++io.locks;
    return 0;
}

void unlockInterrupts(uint8_t) { --io.locks; }

}  // namespace hal
