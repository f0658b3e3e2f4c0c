// SPDX-License-Identifier: GPL-3.0-or-later
// The APM 2's RC encoder (ATmega32U2): eight receiver channels as one PPM-sum. A channel is the
// time from one rising edge to the next; every edge starts a 400 us pulse.
#pragma once
#include <array>
#include <cstdint>

namespace simulator {

class PpmEncoder {
public:
    static constexpr int kChannels = 8;
    static constexpr uint32_t kPulse_us = 400;
    static constexpr uint32_t kGap_us = 10'500 + kPulse_us;  // last edge to the next frame's first

    // What the encoder does when the transmitter is gone: encoder 2.3.17 falls silent, older ones
    // send throttle 900, sticks 1500 and hold channels 5 to 8.
    enum class Loss { silent, failsafe_values };

    explicit PpmEncoder(Loss loss = Loss::silent) : loss_(loss) {}

    // The transmitter's channels 1..8, taken over with the next frame. Nothing is sent before the
    // first transmission.
    void sticks(const std::array<uint16_t, kChannels>& us, bool transmitting);

    // The next rising edge in half microseconds since power-on; UINT64_MAX: silent.
    // Whoever has raised it calls passEdge().
    uint64_t nextEdge_us_x2() const { return next_edge_; }
    void passEdge();

    // The time for edges to start from when transmission begins. World does that.
    void advanceTo(uint64_t now_us) { now_us_ = now_us; }

    void setLoss(Loss loss) { loss_ = loss; }
    void jam(bool jammed);  // nothing of the transmitter arrives

private:
    void begin();
    bool sending() const;
    std::array<uint16_t, kChannels> sentChannels() const;

    Loss loss_;
    std::array<uint16_t, kChannels> sticks_{}, frame_{};
    bool heard() const { return transmitting_ && !jammed_; }

    bool transmitting_ = false, ever_ = false, jammed_ = false;
    int channel_ = 0;  // whose width follows the next edge; kChannels: the gap
    uint64_t next_edge_ = UINT64_MAX;
    uint64_t now_us_ = 0;
};

}  // namespace simulator
