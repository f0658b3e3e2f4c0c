// SPDX-License-Identifier: GPL-3.0-or-later
// The board's one relay.
#pragma once

namespace firmware {
namespace actuators {

void relaySet(bool on);
bool relayGet();

}  // namespace actuators
}  // namespace firmware
