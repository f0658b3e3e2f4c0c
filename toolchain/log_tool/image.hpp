// SPDX-License-Identifier: GPL-3.0-or-later
// The logs in an image of the DataFlash, all pages one behind the other.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "toolchain/log_tool/log_file.hpp"

namespace log_tool {

struct StoredLog {
    int number;
    unsigned pages = 0, damaged = 0;  // damaged: their data do not match their checksum
    uint32_t lost = 0;                // bytes of its beginning that the ring has overwritten
    Bytes bytes;                      // without the pages' heads
};

bool isImage(size_t bytes);
std::vector<StoredLog> logsIn(const Bytes& image);  // in their order

}  // namespace log_tool
