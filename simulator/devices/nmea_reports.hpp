// SPDX-License-Identifier: GPL-3.0-or-later
// NMEA 0183 sentences made from a fix; the talker is GP, GN, ...
#pragma once
#include <string>
#include <vector>

#include "simulator/devices/gps_fix.hpp"

namespace simulator {

std::vector<uint8_t> nmeaGga(const GpsFix& fix, const std::string& talker);
std::vector<uint8_t> nmeaRmc(const GpsFix& fix, const std::string& talker);
std::vector<uint8_t> nmeaVtg(const GpsFix& fix, const std::string& talker);
std::vector<uint8_t> nmeaGll(const GpsFix& fix, const std::string& talker);
std::vector<uint8_t> nmeaGsv(const GpsFix& fix, const std::string& talker);  // all of its sentences
std::vector<uint8_t> nmeaGsa(const GpsFix& fix, const std::string& talker);

}  // namespace simulator
