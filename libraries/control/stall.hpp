// SPDX-License-Identifier: GPL-3.0-or-later
// Notices a stall by the nose and leads out of it, without a sensor for the angle of attack. A wing
// that flies turns within a few tenths of a second with the elevator; a stalled one stays down
// however far it is pulled, and is held in the stall by that. Where the nose stays up for all that,
// the airplane falls, and the air meets the wing from far below.
#pragma once
#include <stdint.h>

#include "core/fixed.hpp"

namespace control {

struct StallSigns {
    core::Ratio elevator;      // as the pitch loop has it, up
    core::Angle short_rad;     // from the nose up to what is demanded
    core::BodyRate rate_rads;  // nose up, beyond the turn's
    bool slow;                 // below the lowest flying speed
    bool sinks;                // or nobody knows
    bool falls;                // with its nose far above its path
};

class Stall {
public:
    enum class Phase : uint8_t {
        flying,
        breaking,     // the elevator lets go, until air flows along the wing again
        pulling_out,  // the nose comes up, no faster than a slow wing bears
    };

    void run(const StallSigns& signs);  // 20 Hz
    void runCalm() {                    // in flight, instead: without this elevator there is none
        if (seen_ > 0) --seen_;
    }
    static constexpr bool calm(core::Ratio elevator) { return elevator.raw <= kLeastUp.raw; }
    void stop() { *this = Stall(); }
    Phase phase() const { return phase_; }

private:
    static constexpr core::Ratio kLeastUp{0.35f};  // when it is slow
    static constexpr core::Ratio kHolds{0.15f};    // when it falls

    void begin(Phase phase);
    void breakIt(const StallSigns& signs);
    void watch(const StallSigns& signs);

    Phase phase_ = Phase::flying;
    uint8_t steps_ = 0;  // in the phase
    uint8_t seen_ = 0;   // steps with all signs of a stall, less those without
};

}  // namespace control
