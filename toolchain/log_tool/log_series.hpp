// SPDX-License-Identifier: GPL-3.0-or-later
// What of a log becomes which series: web/src/source/log_series.json.
#pragma once
#include "simulator/report/flight_document.hpp"
#include "toolchain/log_tool/log_file.hpp"

namespace log_tool {

// Every so many records of a long log, so that a report stays small; of two rows with one name and
// kind the first that the log has.
void addSeries(simulator::FlightDocument& document, const LogFile& log);

double seconds(const Record& record);  // NaN: it has no time

}  // namespace log_tool
