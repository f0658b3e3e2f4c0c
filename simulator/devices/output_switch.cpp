// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/output_switch.hpp"

namespace simulator {
namespace {

constexpr uint16_t kToReceiver_us = 1800, kToFirmware_us = 1600;
constexpr uint64_t kLooksEvery_us = 30'000;
constexpr unsigned kLooks = 5;

}  // namespace

void OutputSwitch::run(uint16_t channel_us, uint64_t now_us) {
    if (now_us < next_look_us_) return;
    next_look_us_ = now_us + kLooksEvery_us;
    const bool other = to_receiver_ ? channel_us < kToFirmware_us : channel_us > kToReceiver_us;
    looks_ = other ? looks_ + 1 : 0;
    if (looks_ < kLooks) return;
    to_receiver_ = !to_receiver_;
    looks_ = 0;
}

}  // namespace simulator
