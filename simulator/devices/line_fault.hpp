// SPDX-License-Identifier: GPL-3.0-or-later
// What a disturbed line makes of the bytes that cross it.
#pragma once
#include <cstdint>

#include "simulator/devices/faults.hpp"
#include "simulator/devices/random.hpp"

namespace simulator {

class LineFault {
public:
    explicit LineFault(uint64_t seed) : random_(seed, 17) {}

    void fail(FaultKind kind) { kind_ = kind; }
    FaultKind kind() const { return kind_; }
    bool stuck() const { return kind_ == FaultKind::scl_low || kind_ == FaultKind::sda_low; }

    // Of noise one byte in ten has a bit turned over.
    bool hits() { return kind_ == FaultKind::noisy && random_.uniform() < 0.1; }
    uint8_t through(uint8_t byte) {
        if (kind_ == FaultKind::miso_low || kind_ == FaultKind::sda_low) return 0;
        if (kind_ == FaultKind::miso_high) return 0xFF;
        return hits() ? static_cast<uint8_t>(byte ^ 1 << random_.bits() % 8) : byte;
    }

private:
    Random random_;
    FaultKind kind_ = FaultKind::none;
};

}  // namespace simulator
