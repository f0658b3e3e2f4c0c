// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/log_tool/image.hpp"

#include <algorithm>
#include <cstring>
#include <map>

#include "hal/page_flash.hpp"
#include "logging/page.hpp"

namespace log_tool {
namespace {

constexpr int kHalf = 0x8000;  // of the numbers that logs can have

size_t pageSize(size_t bytes) {
    for (const size_t page : {528u, 512u})
        for (const size_t pages : {4096u, 8192u})
            if (bytes == page * pages) return page;
    return 0;
}

struct Page {
    logging::PageHead head;
    const uint8_t* data;
};

// Behind 65535 comes 1 again: the oldest is behind the gap.
void bringInOrder(std::vector<StoredLog>& logs) {
    const auto oldest = std::adjacent_find(
        logs.begin(), logs.end(), [](auto& a, auto& b) { return b.number - a.number > kHalf; });
    if (oldest != logs.end()) std::rotate(logs.begin(), oldest + 1, logs.end());
}

}  // namespace

bool isImage(size_t bytes) { return pageSize(bytes) != 0; }

std::vector<StoredLog> logsIn(const Bytes& image) {
    const size_t size = pageSize(image.size());
    std::map<std::pair<int, uint32_t>, Page> pages;
    for (size_t at = hal::kFlashMissionPages * size; size != 0 && at < image.size(); at += size) {
        Page page;
        std::memcpy(&page.head, &image[at], sizeof page.head);
        page.data = &image[at + sizeof page.head];
        if (logging::isWhole(page.head, static_cast<uint16_t>(size)))
            pages[{int{page.head.key.log}, uint32_t{page.head.key.offset}}] = page;
    }
    std::vector<StoredLog> logs;
    for (const auto& [key, page] : pages) {
        if (logs.empty() || logs.back().number != key.first) {
            logs.emplace_back();
            logs.back().number = key.first;
            logs.back().lost = key.second;
        }
        StoredLog& log = logs.back();
        ++log.pages;
        const uint16_t crc = core::crc16(core::kCrcStart, page.data, page.head.used);
        log.damaged += crc != page.head.data_crc;
        log.bytes.insert(log.bytes.end(), page.data, page.data + page.head.used);
    }
    bringInOrder(logs);
    return logs;
}

}  // namespace log_tool
