// SPDX-License-Identifier: GPL-3.0-or-later
// What the supply does to the chip: its reference, the bytes of the EEPROM that are written while
// it is too low, the brown-out that holds the chip in reset, and what of the memory is left
// afterwards (ATmega2560 data sheet 12.2, 12.3 and 31.5).
#pragma once
#include <functional>

#include "simulator/devices/random.hpp"
#include "simulator/devices/supply.hpp"
#include "simulator/machine/chip.hpp"

namespace simulator {

class ChipSupply {
public:
    ChipSupply(Chip& chip, const Supply& supply, double band_gap_v, uint64_t seed);

    // As Chip::run, through whatever the supply does until then.
    bool run(uint64_t until_us);
    bool held() const { return held_; }

    std::function<void(uint64_t now_us)> on_skip;  // while the chip is held: so much later it is

private:
    void follow(uint64_t now_us);
    void skip(uint64_t until_us);
    void hold();
    void release();
    void forgetMemory();
    uint64_t nextChange_us(uint64_t now_us) const;
    uint64_t now_us() const { return chip_.cycle() / kCyclesPer_us; }

    Chip& chip_;
    const Supply& supply_;
    Random random_;
    bool held_ = false, powered_off_ = false, forgotten_ = false;
};

}  // namespace simulator
