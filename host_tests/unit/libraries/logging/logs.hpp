// SPDX-License-Identifier: GPL-3.0-or-later
// A store on the simulator's chip, and what a test has written into it, byte for byte.
#pragma once
#include <gtest/gtest.h>
#include <string.h>

#include <algorithm>
#include <map>
#include <random>
#include <vector>

#include "chip.hpp"
#include "hal/page_flash.hpp"
#include "logging/log_store.hpp"

namespace chip {

using core::Status;
using logging::Key;
using logging::LogStore;
using logging::PageHead;
using Bytes = std::vector<uint8_t>;

constexpr uint16_t kFirst = hal::kFlashMissionPages;

class Logs : public testing::Test {
protected:
    void SetUp() override {
        fakes::resetClock();
        chip::fit({true, true});  // the smaller one
        open();
    }
    // As at a start; returns how long it took.
    uint64_t open(uint16_t base = 0) {
        const uint64_t began_us = fakes::time_us();
        store = LogStore();
        store.start(base);
        looks = 0;
        longest_us = 0;
        while (store.usable() && !store.ready()) {
            const uint64_t before_us = fakes::time_us();
            if (!store.find()) fakes::advance_us(100);
            longest_us = std::max(longest_us, fakes::time_us() - before_us);
            if (++looks > 10'000) ADD_FAILURE() << "the end is never found";
            if (looks > 10'000) break;
        }
        return fakes::time_us() - began_us;
    }
    uint16_t ring() const { return hal::flashShape().pages - kFirst; }
    uint16_t room() const { return hal::flashShape().page_size - sizeof(PageHead); }

    // A record of this size, in its own bytes.
    Bytes record(uint8_t size) {
        Bytes bytes(size);
        for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(random());
        return bytes;
    }
    void put(const Bytes& bytes) {
        for (int i = 0; i < 100'000; ++i) {
            const Status status = store.put(bytes.data(), static_cast<uint8_t>(bytes.size()));
            if (status == Status::ok) {
                written[log].insert(written[log].end(), bytes.begin(), bytes.end());
                return;
            }
            ASSERT_EQ(status, Status::busy);
            fakes::advance_us(500);
        }
        FAIL() << "busy for ever";
    }
    void begin() {
        while (store.begin() == Status::busy) fakes::advance_us(500);
        ASSERT_TRUE(store.writing());
        log = store.last() == 65535 ? 1 : static_cast<uint16_t>(store.last() + 1);
        written[log].clear();
    }
    void end() {
        while (store.end() == Status::busy) fakes::advance_us(500);
        settle();
    }
    void settle() { fakes::advance_ms(50); }
    // A log of whole pages: three records fill one.
    void writeLog(unsigned pages) {
        begin();
        for (unsigned i = 0; i < 3 * pages; ++i) {
            put(record(static_cast<uint8_t>(room() / 3)));
        }
        end();
    }
    uint16_t pageOf(uint16_t number, uint32_t offset, PageHead& head) {
        LogStore::Search search = {0, store.pages()};
        Status status = Status::busy;
        for (int i = 0; i < 100 && status == Status::busy; ++i) {
            status = store.seek({number, offset}, search);
            fakes::advance_us(100);
        }
        EXPECT_EQ(status, Status::ok);
        EXPECT_EQ(store.readHead(search.first, head), Status::ok);
        return search.first;
    }
    // What the chip has of this log from its first page there on.
    Bytes readBack(uint16_t number, uint32_t* first = nullptr) {
        Bytes bytes;
        bool begun = false;
        for (uint16_t page = 0; page < store.pages(); ++page) {
            PageHead head;
            const Status status = store.readHead(page, head);
            if (status != Status::ok || head.key.log != number) continue;
            if (!begun && first) *first = head.key.offset;
            begun = true;
            Bytes part(head.used);
            for (uint16_t at = 0; at < head.used; at += 64) {
                const auto size = static_cast<uint8_t>(std::min<int>(64, head.used - at));
                EXPECT_EQ(store.read(page, at, &part[at], size), Status::ok);
            }
            bytes.insert(bytes.end(), part.begin(), part.end());
        }
        return bytes;
    }

    LogStore store;
    uint16_t log = 0;  // the one being written
    std::map<uint16_t, Bytes> written;
    std::mt19937 random{1};
    int looks = 0;
    uint64_t longest_us = 0;
};

}  // namespace chip
