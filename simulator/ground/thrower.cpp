// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/thrower.hpp"

#include "simulator/ground/telemetry.hpp"

namespace simulator {

constexpr int kBeats = 3;

void Thrower::take(const mavlink::Frame& frame) {
    const auto beat = as<mavlink::Heartbeat>(frame);
    if (!beat) return;
    const bool armed = (beat->base_mode & mavlink::MavModeFlag::safety_armed) != 0;
    beats_ = armed && beat->custom_mode == kModeAuto ? beats_ + 1 : 0;
    if (beats_ >= kBeats) board_.world().launch();
}

}  // namespace simulator
