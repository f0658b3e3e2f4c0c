// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/flag_registers.hpp"

#include "simulator/machine/level_interrupt.hpp"
#include "simulator/machine/registers.hpp"

namespace simulator {

constexpr uint16_t kFlagRegisters[] = {0x35, 0x36, 0x37, 0x38, 0x39, 0x3A, kPcifr, kEifr};  // TIFRn
// TIMSKn, EIMSK, PCICR, ADCSRA, ACSR, WDTCSR: the masks that no other mend looks after.
constexpr uint16_t kMaskRegisters[] = {0x6E, 0x6F, 0x70, 0x71, 0x72, 0x73,
                                       0x3D, 0x68, 0x7A, 0x50, 0x60};

FlagRegisters::FlagRegisters(avr_t* avr) : avr_(avr) {
    for (uint16_t address : kFlagRegisters)
        hookWrite<&FlagRegisters::clearWritten>(avr, address, this);
    for (uint16_t address : kMaskRegisters)
        masks_[address] = hookWrite<&FlagRegisters::raiseEnabled>(avr, address, this);
}

void FlagRegisters::clearWritten(uint16_t address, uint8_t value) {
    const uint8_t ones = writtenBits(avr_, value);
    avr_->data[address] &= static_cast<uint8_t>(~ones);
    for (int i = 0; i < avr_->interrupts.vector_count; i++) {
        avr_int_vector_t* vector = avr_->interrupts.vector[i];
        if (vector->raised.reg != address || !(ones & 1 << vector->raised.bit)) continue;
        avr_clear_interrupt(avr_, vector);
    }
}

void FlagRegisters::raiseEnabled(uint16_t address, uint8_t value) {
    masks_[address](avr_, address, value);
    for (int i = 0; i < avr_->interrupts.vector_count; i++) {
        avr_int_vector_t* vector = avr_->interrupts.vector[i];
        if (vector->enable.reg != address || !vector->raised.reg || vector->pending) continue;
        if (avr_regbit_get(avr_, vector->enable) && avr_regbit_get(avr_, vector->raised))
            requestInterrupt(avr_, vector);
    }
}

}  // namespace simulator
