// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/state/vehicle.hpp"

#include "firmware/state/schedule_figures.hpp"

namespace firmware {
namespace state {

Vehicle vehicle;
ScheduleFigures schedule_figures;

}  // namespace state
}  // namespace firmware
