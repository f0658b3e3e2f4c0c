// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/control/autotune.hpp"

#include "firmware/modes/modes_table.hpp"

namespace firmware {
namespace modes {

// FBWA flies it (runFbwa); the gains are tuned behind the control loops.
EntryResult startAutotune() {
    control::startTuning();
    return EntryResult::entered;
}

}  // namespace modes
}  // namespace firmware
