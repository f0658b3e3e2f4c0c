// SPDX-License-Identifier: GPL-3.0-or-later
// A mission as one page of HTML that opens offline: map, height profile, table, findings. It is as
// wide as a telephone (390 px) or wider, and dark where the reader's system is.
#pragma once
#include <string>

#include "toolchain/mission_tool/estimate.hpp"
#include "toolchain/mission_tool/findings.hpp"

namespace mission_tool {

struct PageOf {
    const Document& document;
    const FlightOrder& order;
    const Estimate& flight;
    const std::vector<Finding>& findings;
    std::string airplane;
    Wind wind;
};
std::string pageOf(const PageOf& page);

}  // namespace mission_tool
