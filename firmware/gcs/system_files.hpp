// SPDX-License-Identifier: GPL-3.0-or-later
// Figures of the firmware as text files, for who looks into what it does: lines of 32 characters, a
// name, what it is and, of a task, its budget.
#pragma once
#include <stdint.h>

namespace firmware {
namespace gcs {

enum class SystemFile : uint8_t {
    tasks,   // the longest run of each since start and its budget, us
    memory,  // bytes
    errors,  // counts since start
};

uint16_t systemFileSize(SystemFile file);
// Copies up to `size` bytes from `offset` on; returns how many, fewer only where the file ends.
uint8_t systemFileRead(SystemFile file, uint16_t offset, uint8_t* to, uint8_t size);

}  // namespace gcs
}  // namespace firmware
