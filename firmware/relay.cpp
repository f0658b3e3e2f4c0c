// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/relay.hpp"

#include "board.hpp"

namespace firmware {
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

}  // namespace firmware
