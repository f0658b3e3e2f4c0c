// SPDX-License-Identifier: GPL-3.0-or-later
// The encoder's PPM-sum on the board's capture pin, its edges to the half microsecond.
#pragma once
#include <functional>

#include "simulator/devices/ppm_encoder.hpp"
#include "simulator/machine/board_wiring.hpp"
#include "simulator/machine/chip.hpp"

namespace simulator {

class RadioLine {
public:
    RadioLine(Chip& chip, PpmEncoder& encoder, const BoardWiring& wiring)
        : chip_(chip), encoder_(encoder), pin_(wiring.radio), timer_(wiring.radio_timer) {
        level(false, 0);
    }

    // To be called now and then: the transmitter may have been switched on.
    void plan() {
        const uint64_t next = encoder_.nextEdge_us_x2();
        if (next == UINT64_MAX || planned_) return;
        planned_ = true;
        startTimerAt<&RadioLine::rise>(chip_.avr(), next * kCyclesPer_us / 2, this);
    }
    void restart() {  // after a reset, which drops the timers
        planned_ = false;
        plan();
    }

    // While the chip takes no notice.
    void pass(uint64_t now_us) {
        while (encoder_.nextEdge_us_x2() <= 2 * now_us) encoder_.passEdge();
    }

    std::function<void(bool high)> on_level;

private:
    uint64_t rise(uint64_t due) {
        planned_ = false;
        const bool withdrawn = encoder_.nextEdge_us_x2() > due * 2 / kCyclesPer_us;
        if (withdrawn) {
            plan();
            return 0;
        }
        level(true, due);
        startTimerAt<&RadioLine::fall>(chip_.avr(), due + PpmEncoder::kPulse_us * kCyclesPer_us,
                                       this);
        encoder_.passEdge();
        restart();
        return 0;
    }
    uint64_t fall(uint64_t due) {
        level(false, due);
        return 0;
    }
    void level(bool high, uint64_t cycle) {
        chip_.drive(pin_.port, pin_.bit, high);
        chip_.captureEdge(timer_, high, cycle);
        if (on_level) on_level(high);
    }

    Chip& chip_;
    PpmEncoder& encoder_;
    const PinName pin_;
    const char timer_;
    bool planned_ = false;
};

}  // namespace simulator
