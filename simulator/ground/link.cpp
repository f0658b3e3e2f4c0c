// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/link.hpp"

namespace simulator {

void Link::receive(uint8_t byte, uint64_t time_us) {
    for (bool whole = parser_.put(byte); whole; whole = parser_.next()) {
        handler_(parser_.frame(), time_us);
    }
}

}  // namespace simulator
