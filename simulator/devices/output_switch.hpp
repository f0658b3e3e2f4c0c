// SPDX-License-Identifier: GPL-3.0-or-later
// The first board's multiplexer: channel 8 of the receiver connects outputs 1 to 4 with the
// receiver, whatever the firmware gives. Above 1800 us to the receiver, below 1600 us to the
// firmware, each when five looks of the encoder, 30 ms apart, agree (Encoder-PPM of ArduPPM for the
// ATmega328P; APM 1 manual, "hardware manual").
#pragma once
#include <cstdint>

namespace simulator {

class OutputSwitch {
public:
    static constexpr int kOutputs = 4, kChannel = 8;

    // At any time, with the width that the encoder sends for channel 8.
    void run(uint16_t channel_us, uint64_t now_us);
    void reset() { *this = OutputSwitch(); }
    bool toReceiver() const { return to_receiver_; }

private:
    bool to_receiver_ = false;
    unsigned looks_ = 0;  // in a row that want the other side
    uint64_t next_look_us_ = 0;
};

}  // namespace simulator
