// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/passive_gcs.hpp"

namespace simulator {

// Three times, as nobody says whether it was heard.
void PassiveGcs::step(uint64_t now_us) {
    constexpr uint64_t kAgain_us = 2'000'000;
    if (messages_ == 0 || tries_ == 3 || now_us - asked_us_ < kAgain_us) return;
    ++tries_;
    asked_us_ = now_us;
    mavlink::RequestDataStream request{};
    request.target_system = system_;
    request.target_component = component_;
    request.req_stream_id = mavlink::MavDataStream::all;
    request.req_message_rate = 10;
    request.start_stop = 1;
    link_.send(request);
}

void PassiveGcs::take(const mavlink::Frame& frame) {
    ++messages_;
    system_ = frame.system;
    component_ = frame.component;
}

}  // namespace simulator
