// SPDX-License-Identifier: GPL-3.0-or-later
// The EEPROM with the time it takes: 3.4 ms a byte, the CPU halted for 4 cycles by a read and 2
// by a write, EE_READY for as long as it is ready (datasheet 8.3, tables 8-1 and 8-2). Until the
// byte is done it reads 0xFF, which is what a power cut then leaves behind in a snapshot of it.
#pragma once
#include <simavr/avr_eeprom.h>

#include <vector>

#include "simulator/devices/random.hpp"
#include "simulator/devices/worn_cells.hpp"
#include "simulator/machine/level_interrupt.hpp"

namespace simulator {

class Eeprom : public Mend {
public:
    explicit Eeprom(avr_t* avr);
    void reset() override;  // a write under way goes on

    std::vector<uint8_t> contents() const;
    void setContents(const std::vector<uint8_t>& image);  // what it does not cover: 0xFF
    // While endangered, as the supply is too low for it, a byte that is being written becomes
    // whatever chance will have; so it does when the chip is reset by that.
    void seed(uint64_t seed) { random_ = Random(seed, 16); }
    void endanger(bool endangered);
    void breakOff();
    void wear(const WornCells& worn) { worn_ = worn; }

    bool busy() const { return busy_; }
    uint64_t writes() const { return writes_; }

private:
    bool ready() const { return !busy_; }
    void control(uint16_t address, uint8_t value);
    uint8_t readControl(uint16_t address);
    void beginWrite();
    uint64_t written(uint64_t);

    avr_t* avr_;
    avr_eeprom_t* io_;
    LevelInterrupt<Eeprom, &Eeprom::ready> ready_interrupt_;
    bool busy_ = false;
    uint16_t address_ = 0;
    uint8_t value_ = 0;
    uint64_t done_ = 0;           // cycle at which the write ends
    uint64_t enabled_until_ = 0;  // the four cycles after EEMPE
    uint64_t writes_ = 0;
    Random random_{1, 16};
    WornCells worn_;
    bool endangered_ = false, spoilt_ = false;
};

}  // namespace simulator
