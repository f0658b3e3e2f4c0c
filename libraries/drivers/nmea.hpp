// SPDX-License-Identifier: GPL-3.0-or-later
// Reads NMEA 0183 sentences of any talker, in integers: GGA and RMC of one time make a fix; GSA,
// where it is sent, distinguishes two dimensions from three.
#pragma once
#include "drivers/gps_epoch.hpp"

namespace drivers {

// A whole sentence with a right checksum. True: epoch.fix is new and whole.
bool readNmea(const uint8_t* sentence, GpsEpoch& epoch);

// Of a talker: $P begins what makers send, and what this driver sends to them.
bool isOfNmea(const uint8_t* sentence);

}  // namespace drivers
