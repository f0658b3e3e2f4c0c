// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/vehicle.hpp"

namespace firmware {

Vehicle vehicle;

}  // namespace firmware
