// SPDX-License-Identifier: GPL-3.0-or-later
// All parameters as one file, as ArduPilot's @PARAM/param.pck.
#pragma once
#include <stdint.h>

#include "core/status.hpp"
#include "parameters/file.hpp"

namespace firmware {
namespace state {

uint16_t parameterFileSize();
// See parameters::readFile().
core::Status parameterFileRead(parameters::FileCursor& cursor, uint16_t offset, uint8_t* to,
                               uint8_t& size);

}  // namespace state
}  // namespace firmware
