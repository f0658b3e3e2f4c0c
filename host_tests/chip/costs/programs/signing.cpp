// SPDX-License-Identifier: GPL-3.0-or-later
// SHA-256 of one block, with interrupts off: all of it, and what one slice takes.
#include "crypto/sha256.hpp"
#include "steps.hpp"

namespace {

crypto::Sha256 sha;

void fill() {
    sha.byte(0) = 'a';
    sha.byte(1) = 'b';
    sha.byte(2) = 'c';
    sha.pad(0, 3);
}

}  // namespace

int main() {
    hal::trace(hal::kTraceFrameBegin);  // without frames nothing is measured
    sha.begin();
    fill();
    costs::timed(costs::kHashBlock, [] {
        while (!sha.quarter()) {
        }
    });
    if (sha.hash(0) != 0xba || sha.hash(31) != 0xad) hal::trace(costs::kBroken);
    sha.begin();
    fill();
    for (uint8_t i = 0; i < crypto::kQuarters; ++i)
        costs::timed(costs::kHashQuarter, [] { sha.quarter(); });
    for (uint8_t i = 0; i < 8; ++i) costs::timed(costs::kNothing, [] {});
    for (;;) {
    }
}
