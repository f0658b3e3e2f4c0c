// SPDX-License-Identifier: GPL-3.0-or-later
// What the ground link asks of the rooms above it; app/gcs_host.cpp fills it in.
#pragma once
#include <stdint.h>

#include "firmware/notify/status_text.hpp"

namespace firmware {
namespace gcs {

struct TaskFigures {
    notify::StatusText name;
    uint16_t longest_us;  // since start
    uint16_t budget_us;
};

struct Host {
    uint8_t (*taskCount)();
    TaskFigures (*taskFigures)(uint8_t task);
};
extern const Host host;

}  // namespace gcs
}  // namespace firmware
