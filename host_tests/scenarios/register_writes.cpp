// SPDX-License-Identifier: GPL-3.0-or-later
// Which of its registers an image writes in its first three seconds on an emulated board, and what:
// for toolchain/image/registers.mjs. Prints a line for each value that a register was given, in the
// order in which it had them first: ADDRESS VALUE start|run, where `start` is before the program
// has first let interrupts in. The bootloader's writes do not count.
//   register_writes FIRMWARE apm1|apm2
#include <array>
#include <cstdio>
#include <cstring>
#include <set>

#include "host_tests/scenarios/flight_report.hpp"
#include "simulator/machine/apm2_board.hpp"
#include "simulator/machine/hooks.hpp"
#include "simulator/machine/registers.hpp"

using namespace simulator;

namespace {

constexpr uint16_t kFirst = 0x20, kEnd = 0x137;
constexpr uint16_t kStackLow = 0x5D, kStatus = 0x5F;
constexpr uint64_t kUntil_us = 3'000'000;
constexpr int kInterrupts = 7;  // of the status register

class Writes {
public:
    explicit Writes(avr_t* avr) : avr_(avr) {
        for (uint16_t at = kFirst; at < kEnd; ++at)
            if (at < kStackLow || at > kStatus)
                before_[at] = hookWrite<&Writes::write>(avr, at, this);
    }

private:
    void write(uint16_t address, uint8_t value) {
        before_[address](avr_, address, value);
        if (avr_->pc >= kBootSection) return;
        running_ = running_ || avr_->sreg[kInterrupts];
        if (!seen_.insert({address, value}).second) return;
        std::printf("%u %u %s\n", unsigned{address}, unsigned{value}, running_ ? "run" : "start");
    }

    avr_t* avr_;
    std::array<WriteChain, kEnd> before_;
    std::set<std::pair<uint16_t, uint8_t>> seen_;
    bool running_ = false;
};

}  // namespace

int main(int count, char** words) {
    if (count != 3) return 2;
    WorldOptions options;
    options.bootloader = Bootloader::quick;
    AvrBoard board(words[1], options,
                   std::strcmp(words[2], "apm1") == 0 ? kApm1Wiring : kApm2Wiring);
    switchTransmitterOn(board.world());
    const Writes writes(board.chip().avr());
    return board.runUntil(kUntil_us) ? 0 : 1;
}
