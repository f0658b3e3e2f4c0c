// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/actuators/relay.hpp"

#include "board.hpp"

namespace firmware {
namespace actuators {

namespace {
bool is_on;
}

void relaySet(bool on) {
    is_on = on;
    if (on)
        board::Relay::high();
    else
        board::Relay::low();
    board::Relay::output();
}

bool relayGet() { return is_on; }

}  // namespace actuators
}  // namespace firmware
