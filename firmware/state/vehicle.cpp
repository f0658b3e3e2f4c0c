// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace state {

Vehicle vehicle;

}  // namespace state
}  // namespace firmware
