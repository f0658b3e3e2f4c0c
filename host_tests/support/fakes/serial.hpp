// SPDX-License-Identifier: GPL-3.0-or-later
// The tests' serial ports: what the program will receive, and what it has sent.
#pragma once
#include <stdint.h>

#include <deque>
#include <string>
#include <vector>

#include "hal/serial.hpp"

namespace fakes {

struct Serial {
    std::deque<uint8_t> in;        // received, not yet read
    std::vector<uint8_t> out;      // sent; a test may clear it
    uint32_t baud = 0;             // of the last serialOpen, 0: not open
    std::vector<uint32_t> opened;  // every rate it was opened with
    uint8_t room = 255;            // for serialWrite; shrinks by what is written unless endless
    bool endless = true;
    std::vector<uint8_t> held;  // frames that wait for their signatures, with room for these
    uint16_t lost = 0;

    void receive(const std::vector<uint8_t>& bytes) {
        in.insert(in.end(), bytes.begin(), bytes.end());
    }
    void receive(const std::string& text) { in.insert(in.end(), text.begin(), text.end()); }
};

Serial& serial(hal::Port port);
void setUsb(bool connected);
void resetSerial();

}  // namespace fakes
