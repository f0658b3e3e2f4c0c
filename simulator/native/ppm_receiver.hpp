// SPDX-License-Identifier: GPL-3.0-or-later
// Decodes the PPM-sum of the on-board encoder from the times of its rising edges.
#pragma once
#include <array>
#include <cstdint>

#include "hal/rc_input.hpp"

namespace simulator {

class PpmEncoder;

class PpmReceiver {
public:
    PpmReceiver(const uint64_t& now_us, PpmEncoder& radio) : now_us_(now_us), radio_(radio) {}

    bool read(uint16_t (&pulse_us)[hal::kRcChannels]);
    uint32_t age_us() const;
    uint16_t newest_us(uint8_t channel) const { return frame_halfus_.at(channel) / 2; }

    void restart() {
        channel_ = -1;
        frame_us_ = UINT64_MAX;
        fresh_ = false;
        frame_halfus_ = {};
    }

    uint64_t due_us() const;
    void run();

private:
    void edge(uint64_t time_halfus);
    void finish();

    const uint64_t& now_us_;
    PpmEncoder& radio_;
    std::array<uint16_t, hal::kRcChannels> building_halfus_{}, frame_halfus_{};
    int channel_ = -1;  // -1: no gap seen yet
    uint64_t last_edge_halfus_ = 0;
    uint64_t frame_us_ = UINT64_MAX;  // when the newest frame was complete
    bool fresh_ = false;
};

}  // namespace simulator
