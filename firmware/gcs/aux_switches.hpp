// SPDX-License-Identifier: GPL-3.0-or-later
// Switches of the transmitter on channels 5 to 8 with a function of their own (RC5_OPTION to
// RC8_OPTION).
#pragma once

namespace firmware {
namespace gcs {

// 10 Hz. A function is carried out when its switch is moved: not for where it stands at the start,
// after a restart in the air or when its parameter is set. What is refused is reported as for a
// command.
void runAuxSwitches();

}  // namespace gcs
}  // namespace firmware
