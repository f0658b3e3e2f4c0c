// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/state/parameter_host.hpp"

#include "firmware/actuators/outputs.hpp"

namespace firmware {
namespace state {

const ParameterHost parameter_host = {actuators::isOutputFunction};

}  // namespace state
}  // namespace firmware
