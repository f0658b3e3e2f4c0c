// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/state/vehicle.hpp"

#include "firmware/state/processor_figures.hpp"

namespace firmware {
namespace state {

core::FileState<Vehicle> VehicleStorage::vehicle_{};
core::FileState<ProcessorFigures> processor_figures{};

}  // namespace state
}  // namespace firmware
