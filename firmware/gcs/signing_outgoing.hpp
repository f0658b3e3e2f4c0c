// SPDX-License-Identifier: GPL-3.0-or-later
// Signatures of what is sent: with a key and SIGN_POLICY, every frame is MAVLink 2, waits in its
// port's buffer, and goes out with its signature. The time is that of the GPS, of the ground
// station or of the last run, whichever is latest, and runs on from there.
#pragma once
#include <stdint.h>

#include "firmware/gcs/link.hpp"

namespace firmware {
namespace gcs {

void outgoingSigningStart();
void outgoingTimeAtLeast(uint32_t upper);  // of a time, its upper 32 bits

// One slice of the work on the link's oldest frame. False: nothing waits, or it has to wait on.
bool signOutgoing(Link& link);

}  // namespace gcs
}  // namespace firmware
