// SPDX-License-Identifier: GPL-3.0-or-later
// The board's DataFlash and who may use it when; what others ask of it is in hal/page_flash.hpp.
#pragma once

namespace firmware {
namespace app {

void dataflashStart();
// Ten times a second or so: finds the chip, sees that it finishes what it was asked to do, and
// warns the pilot when it does not.
void dataflashStep();

}  // namespace app
}  // namespace firmware
