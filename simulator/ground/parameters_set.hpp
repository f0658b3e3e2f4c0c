// SPDX-License-Identifier: GPL-3.0-or-later
// Which parameters ground stations have set in a flight, and to what: what the autopilot answered
// to each PARAM_SET, which it may have refused or rounded.
#pragma once
#include <map>
#include <set>
#include <string>

#include "mavlink/messages.hpp"
#include "mavlink/peer.hpp"

namespace simulator {

class ParametersSet {
public:
    void sent(const mavlink::Frame& frame);      // to the autopilot
    void received(const mavlink::Frame& frame);  // from it

    const std::map<std::string, double>& values() const { return values_; }

private:
    std::set<std::string> asked_;
    std::map<std::string, double> values_;
};

}  // namespace simulator
