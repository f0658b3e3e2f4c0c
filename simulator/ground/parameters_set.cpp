// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/parameters_set.hpp"

#include <cstring>

#include "simulator/ground/link.hpp"

namespace simulator {

using namespace mavlink;

template <class Message>
static std::string nameIn(const Message& message) {
    return {message.param_id, strnlen(message.param_id, sizeof message.param_id)};
}

void ParametersSet::sent(const Frame& frame) {
    if (const auto set = as<ParamSet>(frame)) asked_.insert(nameIn(*set));
}

void ParametersSet::received(const Frame& frame) {
    const auto value = as<ParamValue>(frame);
    if (value && asked_.count(nameIn(*value)) > 0)
        values_[nameIn(*value)] = double{value->param_value};
}

}  // namespace simulator
