// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/parameter_upload.hpp"

#include <cmath>
#include <sstream>

namespace simulator {

using namespace mavlink;

constexpr uint64_t kAgain_us = 500'000;
constexpr int kTries = 6;
constexpr uint8_t kReal32 = 9;  // MAV_PARAM_TYPE

void ParameterUpload::step(uint64_t now_us, uint8_t system, uint8_t component) {
    if (done() || !failure_.empty()) return;
    if (tries_ > 0 && now_us - sent_us_ < kAgain_us) return;
    const ParameterSetting& setting = settings_[next_];
    if (tries_ == kTries) {
        failure_ = "parameter " + setting.name + ": " +
                   (answered_.empty() ? "the autopilot does not answer" : answered_);
        return;
    }
    ++tries_;
    sent_us_ = now_us;
    ParamSet message{};
    message.param_value = static_cast<float>(setting.value);
    message.target_system = system;
    message.target_component = component;
    setting.name.copy(message.param_id, sizeof message.param_id);
    message.param_type = kReal32;
    link_.send(message);
}

void ParameterUpload::take(const Frame& frame) {
    const auto value = as<ParamValue>(frame);
    if (!value || done()) return;
    const ParameterSetting& setting = settings_[next_];
    const std::string name(value->param_id, strnlen(value->param_id, sizeof value->param_id));
    if (name != setting.name) return;
    const auto wanted = static_cast<float>(setting.value);
    if (value->param_value == wanted || value->param_value == std::trunc(wanted)) {
        ++next_;
        tries_ = 0;
        answered_.clear();
    } else {
        std::ostringstream text;
        text << "the autopilot has " << value->param_value << ", not " << setting.value;
        answered_ = text.str();
    }
}

}  // namespace simulator
