// SPDX-License-Identifier: GPL-3.0-or-later
// What the parameters ask of the rooms above them; app/parameter_host.cpp fills it in.
#pragma once
#include <stdint.h>

namespace firmware {
namespace state {

struct ParameterHost {
    bool (*isOutputFunction)(int8_t function);  // for RCn_FUNCTION
};
extern const ParameterHost parameter_host;

}  // namespace state
}  // namespace firmware
