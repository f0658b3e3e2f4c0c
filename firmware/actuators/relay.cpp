// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/actuators/relay.hpp"

#include "board.hpp"
#include "core/file_state.hpp"

namespace firmware {
namespace actuators {

namespace {

struct Relay {
    bool is_on;
};
core::FileState<Relay> relay{};

}  // namespace

void relaySet(bool on) {
    relay.is_on = on;
    if (on)
        board::Relay::high();
    else
        board::Relay::low();
    board::Relay::output();
}

bool relayGet() { return relay.is_on; }

}  // namespace actuators
}  // namespace firmware
