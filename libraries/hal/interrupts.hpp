// SPDX-License-Identifier: GPL-3.0-or-later
// A stretch of code that no interrupt enters; for what is wider than a byte and touched by both.
#pragma once
#include <stdint.h>

namespace hal {

uint8_t lockInterrupts();  // returns what unlockInterrupts wants
void unlockInterrupts(uint8_t previous);

class Locked {
public:
    Locked() : previous_(lockInterrupts()) {}
    ~Locked() { unlockInterrupts(previous_); }
    Locked(const Locked&) = delete;
    Locked& operator=(const Locked&) = delete;

private:
    const uint8_t previous_;
};

}  // namespace hal
