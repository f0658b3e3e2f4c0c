// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the UBX messages of a u-blox receiver (u-blox 6 Receiver Description, "UBX Protocol"):
// POSLLH, VELNED, STATUS and SOL, or PVT of the newer ones.
#pragma once
#include "drivers/gps_epoch.hpp"

namespace drivers {

// A whole frame with a right checksum. True: epoch.fix is new and whole.
bool readUblox(const uint8_t* frame, GpsEpoch& epoch);

// Position or an answer to a configuration: what a receiver says by itself or when spoken to, not
// what this driver sends and an open line brings back.
bool isOfUblox(const uint8_t* frame);

}  // namespace drivers
