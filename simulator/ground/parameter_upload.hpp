// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters set by wire, one after the other, each until the autopilot answers with its value.
// Times are emulated.
#pragma once
#include <string>
#include <vector>

#include "simulator/ground/link.hpp"

namespace simulator {

struct ParameterSetting {
    std::string name;
    double value;
};
using ParameterSettings = std::vector<ParameterSetting>;

class ParameterUpload {
public:
    ParameterUpload(Link& link, const ParameterSettings& settings)
        : link_(link), settings_(settings) {}

    void step(uint64_t now_us, uint8_t system, uint8_t component);
    void take(const mavlink::Frame& frame);

    bool done() const { return next_ == settings_.size(); }
    const std::string& failure() const { return failure_; }  // empty: none

private:
    Link& link_;
    const ParameterSettings settings_;
    size_t next_ = 0;
    uint64_t sent_us_ = 0;
    int tries_ = 0;
    std::string answered_;  // what the autopilot answered instead
    std::string failure_;
};

}  // namespace simulator
