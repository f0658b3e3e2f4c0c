// SPDX-License-Identifier: GPL-3.0-or-later
// What PINx reads: the pin itself, also where a timer's compare drives it in place of the port
// (datasheet 13.2.4 and figure 17-5). libsimavr reads the port's register there.
#pragma once
#include <simavr/avr_ioport.h>

#include <array>

#include "simulator/machine/hooks.hpp"
#include "simulator/machine/timer.hpp"

namespace simulator {

class PortPins : public Mend {
public:
    PortPins(avr_t* avr, char name, const std::array<Timer*, 6>& timers)
        : avr_(avr), port_(findPeripheral<avr_ioport_t>(avr, "port", name)), timers_(timers) {
        before_ = hookRead<&PortPins::read>(avr, port_->r_pin, this);
    }

private:
    uint8_t read(uint16_t address) {
        uint8_t pins = before_(avr_, address);
        for (const Timer* timer : timers_) pins = timer->driven(*port_, pins);
        return pins;
    }

    avr_t* avr_;
    avr_ioport_t* port_;
    const std::array<Timer*, 6>& timers_;
    ReadChain before_;
};

}  // namespace simulator
