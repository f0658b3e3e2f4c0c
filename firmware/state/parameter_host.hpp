// SPDX-License-Identifier: GPL-3.0-or-later
// What the parameters ask of the rooms above them; app/parameter_host.cpp fills it in.
#pragma once
#include <stdint.h>

#include "core/status.hpp"
#include "storage/lists.hpp"

namespace firmware {
namespace state {

struct ParameterHost {
    bool (*isOutputFunction)(int8_t function);  // for RCn_FUNCTION
    bool (*acceptsFenceTotal)(uint8_t total);   // for FENCE_TOTAL
    // FENCE_TOTAL and RALLY_TOTAL cut a list off or add blank points; busy: ask again.
    core::Status (*resizePoints)(storage::ListKind kind, uint8_t total);
};
extern const ParameterHost parameter_host;

}  // namespace state
}  // namespace firmware
