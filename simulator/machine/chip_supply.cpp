// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/chip_supply.hpp"

#include <algorithm>
#include <iterator>

namespace simulator {
namespace {

constexpr double kLevels_v[] = {least_v::kEepromWrite, least_v::kChip, least_v::kMemory,
                                least_v::kPowerOnReset};
constexpr uint64_t kSkip_us = 1000;  // the longest step in which time passes while the chip is held

}  // namespace

ChipSupply::ChipSupply(Chip& chip, const Supply& supply, double band_gap_v, uint64_t seed)
    : chip_(chip), supply_(supply), random_(seed, 15) {
    chip_.adc().band_gap_v = band_gap_v;
    chip_.adc().supply_v = [this] { return supply_.volts(now_us()); };
    chip_.eeprom().seed(seed);
}

bool ChipSupply::run(uint64_t until_us) {
    for (;;) {
        follow(now_us());
        const uint64_t now = now_us();
        if (now >= until_us) return true;
        const uint64_t next_us = std::min(until_us, nextChange_us(now));
        if (held_) {
            skip(next_us);
        } else if (!chip_.run(next_us * kCyclesPer_us)) {
            return false;
        }
    }
}

uint64_t ChipSupply::nextChange_us(uint64_t now_us) const {
    uint64_t next_us = UINT64_MAX;
    for (const double level_v : kLevels_v)
        next_us = std::min(next_us, supply_.nextCrossing_us(level_v, now_us));
    return next_us;
}

void ChipSupply::follow(uint64_t now_us) {
    chip_.eeprom().endanger(supply_.below(least_v::kEepromWrite, now_us));
    const bool low = supply_.below(least_v::kChip, now_us);
    if (low && !held_) hold();
    forgotten_ = forgotten_ || supply_.below(least_v::kMemory, now_us);
    powered_off_ = powered_off_ || supply_.below(least_v::kPowerOnReset, now_us);
    if (!low && held_) release();
}

// Its pins are inputs from here on.
void ChipSupply::hold() {
    chip_.eeprom().breakOff();
    chip_.reset(Reset::brown_out);
    held_ = true;
}

void ChipSupply::release() {
    if (forgotten_) forgetMemory();
    chip_.reset(powered_off_ ? Reset::power_on : Reset::brown_out);
    held_ = forgotten_ = powered_off_ = false;
}

void ChipSupply::forgetMemory() {
    constexpr uint16_t kRamStart = 0x200;
    uint8_t* const data = chip_.avr()->data;
    std::generate(data + kRamStart, data + kRamEnd + 1,
                  [this] { return static_cast<uint8_t>(random_.bits()); });
}

void ChipSupply::skip(uint64_t until_us) {
    for (uint64_t now = now_us(); now < until_us;) {
        now = std::min(until_us, now + kSkip_us);
        chip_.skip(now * kCyclesPer_us);
        if (on_skip) on_skip(now);
    }
}

}  // namespace simulator
