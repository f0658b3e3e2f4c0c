// SPDX-License-Identifier: GPL-3.0-or-later
// The board's RC encoder (ATmega32U2 or ATmega328P with ArduPPM): eight wires of a receiver as one
// PPM-sum. A channel is the time from one rising edge to the next; every edge starts a 400 us
// pulse. As its source has it (Encoder-PPM, PPM_Encoder.h of ArduPPM 2.2.65 and later): nothing is
// sent before an input was seen; a pulse outside 900..2100 us is ignored; when no input has changed
// for 250 ms a watchdog puts the failsafe values into all eight channels; after a brown-out these
// are sent without any input.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "simulator/devices/faults.hpp"
#include "simulator/devices/random.hpp"

namespace simulator {

class PpmEncoder {
public:
    static constexpr int kChannels = 8;
    static constexpr uint32_t kPulse_us = 400;
    static constexpr uint32_t kGap_us = 10'500 + kPulse_us;  // last edge to the next frame's first
    static constexpr uint32_t kWatchdog_us = 250'000;
    static constexpr std::array<uint16_t, kChannels> kFailsafe_us = {1500, 1500, 900,  1500,
                                                                     1555, 1500, 1500, 1500};

    explicit PpmEncoder(uint64_t seed = 1) : random_(seed, 13) {}

    // The receiver's outputs 1..8, taken over with the next frame; without transmission it gives no
    // pulses. Nothing is sent before the first transmission.
    void sticks(const std::array<uint16_t, kChannels>& us, bool transmitting);

    // The next rising edge in half microseconds since power-on; UINT64_MAX: silent.
    // Whoever has raised it calls passEdge().
    uint64_t nextEdge_us_x2() const { return next_edge_; }
    void passEdge();

    // The time for edges to start from when transmission begins. World does that.
    void advanceTo(uint64_t now_us);

    // lost: the receiver gives no pulses. held: likewise, with an encoder of ArduPPM 2.3.16, which
    // after a second centres channels 1, 2 and 4, puts 3 to 900 us and holds 5 to 8. silent: no
    // edge comes at all. throttle_lost: wire 3 alone is off. missed_edge, extra_edge: one edge of
    // fifty is not seen, or comes twice. nine_channels, wide: a receiver's own PPM-sum is passed
    // through, with nine channels or with pulses of 700..2300 us.
    void fail(FaultKind kind, uint64_t now_us);

    // The encoder's own supply, and the receiver's before it. From under the threshold of its
    // power-on reset it starts without knowing of a brown-out.
    void power(bool on, uint64_t now_us);
    void forgetBrownOut() { brown_out_ = false; }
    void powerReceiver(bool on, uint64_t now_us);

    // What the transmitter gives, and whether it is heard.
    const std::array<uint16_t, kChannels>& sticks() const { return sticks_; }
    bool heard() const {
        return transmitting_ && receiver_on_ && fault_ != FaultKind::lost &&
               fault_ != FaultKind::held;
    }

    // The width that is sent for a channel, 1 to 8.
    uint16_t sent_us(int channel) const { return sent_[static_cast<size_t>(channel - 1)]; }

private:
    using Channels = std::array<uint16_t, kChannels>;

    void begin();
    bool sending() const;
    void noteInput();
    void takeInputs(uint64_t at_us);
    void takeWire(int channel, uint64_t at_us);
    void takeNothing(uint64_t at_us);
    std::vector<uint16_t> nextFrame(uint64_t at_us);
    void step();
    bool oneOfFifty() { return random_.uniform() < 0.02; }

    Random random_;
    FaultKind fault_ = FaultKind::none;
    Channels sticks_{}, sent_{1500, 1500, 1100, 1500, 1555, 1500, 1500, 1500};
    std::vector<uint16_t> frame_;
    bool transmitting_ = false, ever_ = false;
    bool powered_ = true, receiver_on_ = true;
    bool brown_out_ = false;     // it began with one
    bool heard_before_ = false;  // at the last look
    size_t channel_ = 0;         // whose width follows the next edge; behind the last: the gap
    uint32_t split_x2_ = 0;      // of a width that an extra edge has cut: what is left
    uint64_t next_edge_ = UINT64_MAX;
    uint64_t now_us_ = 0, silent_since_us_ = 0, failed_us_ = 0, powered_us_ = 0;
};

}  // namespace simulator
