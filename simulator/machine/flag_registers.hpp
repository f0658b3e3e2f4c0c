// SPDX-License-Identifier: GPL-3.0-or-later
// Interrupt flags as the datasheet has them: a one written to TIFRn, EIFR or PCIFR clears that flag
// and no other, and a flag that was raised while its interrupt was masked fires when it is enabled.
#pragma once
#include <array>
#include <map>

#include "simulator/machine/hooks.hpp"

namespace simulator {

class FlagRegisters : public Mend {
public:
    explicit FlagRegisters(avr_t* avr);

private:
    void clearWritten(uint16_t address, uint8_t value);
    void raiseEnabled(uint16_t address, uint8_t value);

    avr_t* avr_;
    std::map<uint16_t, WriteChain> masks_;
};

}  // namespace simulator
