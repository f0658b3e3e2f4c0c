// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/state/parameter_host.hpp"

#include "firmware/actuators/outputs.hpp"
#include "firmware/gcs/legacy_points.hpp"

namespace firmware {
namespace state {

const ParameterHost parameter_host = {actuators::isOutputFunction, gcs::fenceTakesTotal,
                                      gcs::resizePoints};

}  // namespace state
}  // namespace firmware
