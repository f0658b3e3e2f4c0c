// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/log_tool/image.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "hal/page_flash.hpp"
#include "logging/page.hpp"

namespace log_tool {
namespace {

constexpr size_t kPage = 528, kPages = 4096;

// One page of a log, `place` pages behind those of the mission.
void putPage(Bytes& image, size_t place, uint16_t log, uint32_t offset) {
    uint8_t* const at = &image[(hal::kFlashMissionPages + place) * kPage];
    logging::PageHead head = {{log, offset}, 100, 0, 0};
    std::memset(at + sizeof head, log & 0xFF, head.used);
    head.data_crc = core::crc16(core::kCrcStart, at + sizeof head, head.used);
    head.head_crc = logging::crcOf(head);
    std::memcpy(at, &head, sizeof head);
}

std::vector<int> numbersIn(const Bytes& image) {
    std::vector<int> numbers;
    for (const StoredLog& log : logsIn(image)) numbers.push_back(log.number);
    return numbers;
}

TEST(LogImage, logs_come_from_the_oldest_to_the_newest_wherever_the_ring_begins) {
    Bytes image(kPages * kPage, 0xFF);
    putPage(image, 0, 9, 0);
    putPage(image, 1, 10, 0);
    putPage(image, 2, 7, 300);
    putPage(image, 3, 8, 0);
    EXPECT_EQ(numbersIn(image), (std::vector<int>{7, 8, 9, 10}));
    EXPECT_EQ(logsIn(image).front().lost, 300u);
}

TEST(LogImage, behind_log_65535_comes_log_1) {
    Bytes image(kPages * kPage, 0xFF);
    putPage(image, 0, 65534, 0);
    putPage(image, 1, 65535, 0);
    putPage(image, 2, 1, 0);
    putPage(image, 3, 1, 100);
    putPage(image, 4, 2, 0);
    EXPECT_EQ(numbersIn(image), (std::vector<int>{65534, 65535, 1, 2}));
    EXPECT_EQ(logsIn(image)[2].pages, 2u);
}

}  // namespace
}  // namespace log_tool
