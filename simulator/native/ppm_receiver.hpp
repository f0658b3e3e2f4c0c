// SPDX-License-Identifier: GPL-3.0-or-later
// Decodes the PPM-sum of the on-board encoder from the times of its rising edges.
#pragma once
#include <cstdint>

#include "drivers/ppm_frames.hpp"
#include "hal/rc_input.hpp"

namespace simulator {

class PpmEncoder;

class PpmReceiver {
public:
    PpmReceiver(const uint64_t& now_us, PpmEncoder& radio) : now_us_(now_us), radio_(radio) {
        restart();
    }

    bool read(uint16_t (&pulse_us)[hal::kRcChannels]);
    uint32_t age_us() const;
    bool readWhole(uint16_t (&pulse_us)[hal::kRcChannels]);
    uint16_t newest_us(uint8_t channel) const { return frames_.newest()[channel] / 2; }

    void restart() {
        frames_ = {};
        frames_.reset();
        frame_us_ = UINT64_MAX;
        fresh_ = false;
    }

    uint64_t due_us() const;
    void run();

private:
    void edge(uint64_t time_halfus);

    const uint64_t& now_us_;
    PpmEncoder& radio_;
    drivers::PpmFrames frames_{};
    uint64_t last_edge_halfus_ = 0;
    uint64_t frame_us_ = UINT64_MAX;  // when the newest frame was complete
    bool fresh_ = false;
};

}  // namespace simulator
