// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/control/autotune.hpp"

#include "firmware/modes/modes_table.hpp"

namespace firmware {
namespace modes {

// FBWA flies it (runFbwa); the gains are tuned behind the control loops.
Entry startAutotune() {
    control::startTuning();
    return Entry::entered;
}

}  // namespace modes
}  // namespace firmware
