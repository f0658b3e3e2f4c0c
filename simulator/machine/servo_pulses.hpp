// SPDX-License-Identifier: GPL-3.0-or-later
// The eight servo outputs of a board: widths of the pulses as they leave the timers' pins.
#pragma once
#include <array>
#include <functional>

#include "simulator/machine/board_wiring.hpp"
#include "simulator/machine/chip.hpp"

namespace simulator {

class ServoPulses {
public:
    static constexpr int kOutputs = 8;

    // Listens to the chip for good. Outputs are numbered 1..8.
    explicit ServoPulses(Chip& chip, const BoardWiring& wiring = kApm2Wiring);

    std::function<void(int output, double width_us)> on_pulse;
    std::function<void(int output, bool high)> on_level;

private:
    struct Level {
        bool high = false;
        uint64_t since = 0;
    };

    void changed(int index, bool high, uint64_t cycle);

    Chip& chip_;
    const std::array<ServoWire, kOutputs> wires_;
    std::array<Level, kOutputs> levels_ = {};
};

}  // namespace simulator
