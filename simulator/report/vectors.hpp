// SPDX-License-Identifier: GPL-3.0-or-later
// The interrupts of the ATmega2560 by name.
#pragma once
#include <string>

namespace simulator {

std::string vectorName(int vector);

}  // namespace simulator
