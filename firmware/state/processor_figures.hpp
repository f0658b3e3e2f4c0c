// SPDX-License-Identifier: GPL-3.0-or-later
// How busy the processor is; app/tasks.cpp publishes it.
#pragma once
#include <stdint.h>

#include "core/file_state.hpp"

namespace firmware {
namespace state {

struct ProcessorFigures {
    uint16_t load_permille;     // of the frames' time spent in tasks, over the last second
    uint16_t late_frames;       // that ran past their period since start
    uint16_t longest_frame_us;  // since start
};
extern core::FileState<ProcessorFigures> processor_figures;

}  // namespace state
}  // namespace firmware
