// SPDX-License-Identifier: GPL-3.0-or-later
// The GPS receivers that can be plugged in, by the names of fly's --gps.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "simulator/devices/gps_receiver.hpp"

namespace simulator {

std::vector<std::string> gpsKinds();

// As delivered; baud 0: at the rate it comes with. Of another kind than these: nothing is plugged
// in, and nothing comes.
std::unique_ptr<GpsReceiver> makeGps(const std::string& kind, uint32_t baud, uint64_t seed,
                                     const SensorErrors& errors, const GpsOptions& options);

}  // namespace simulator
