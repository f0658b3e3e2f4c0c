// SPDX-License-Identifier: GPL-3.0-or-later
// The flight document of a log. web/src/source/log_document.ts makes the same of a log that is
// dropped onto the page, but for the deviations; a test holds them together.
#pragma once
#include <string>

#include "simulator/report/flight_document.hpp"
#include "toolchain/log_tool/log_file.hpp"

namespace log_tool {

// `name`: of the file, as shown.
simulator::FlightDocument documentOf(const LogFile& log, const std::string& name);

}  // namespace log_tool
