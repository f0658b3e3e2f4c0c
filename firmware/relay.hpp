// SPDX-License-Identifier: GPL-3.0-or-later
// The board's one relay.
#pragma once

namespace firmware {

void relaySet(bool on);
bool relayGet();

}  // namespace firmware
