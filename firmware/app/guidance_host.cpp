// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/guidance/host.hpp"

#include "firmware/modes/modes.hpp"

namespace firmware {
namespace guidance {

const Host host = {modes::demandOfMode};

}  // namespace guidance
}  // namespace firmware
