// SPDX-License-Identifier: GPL-3.0-or-later
// The ring of logs: written, found again, cut by losses of power, full, erased.
#include "logs.hpp"

using namespace chip;

namespace {

bool isBeginningOf(const Bytes& part, const Bytes& whole) {
    return part.size() <= whole.size() && std::equal(part.begin(), part.end(), whole.begin());
}

TEST_F(Logs, a_blank_chip_holds_none) {
    EXPECT_EQ(store.last(), 0);
    EXPECT_EQ(store.pages(), 0);
    EXPECT_TRUE(store.usable());
}

TEST_F(Logs, without_a_chip_there_is_nothing_to_use) {
    chip::fit({false});
    open();
    EXPECT_FALSE(store.usable());
    EXPECT_EQ(store.begin(), Status::unsupported);
    uint8_t byte = 0;
    EXPECT_EQ(store.put(&byte, 1), Status::unsupported);
}

TEST_F(Logs, what_was_written_is_read_back_after_a_restart) {
    begin();
    for (int i = 0; i < 200; ++i) put(record(static_cast<uint8_t>(11 + i % 79)));
    end();
    writeLog(3);
    chip::restart();
    open();

    EXPECT_EQ(store.last(), 2);
    EXPECT_EQ(readBack(1), written[1]);
    EXPECT_EQ(readBack(2), written[2]);
}

TEST_F(Logs, a_log_of_which_nothing_was_stored_has_no_number) {
    writeLog(1);
    begin();
    EXPECT_EQ(store.last(), 1);
    end();
    EXPECT_EQ(store.last(), 1);
    writeLog(1);
    EXPECT_EQ(store.last(), 2);
    EXPECT_EQ(readBack(2), written[2]);
}

TEST_F(Logs, a_record_never_waits_longer_than_the_chip_programs_a_page) {
    chip::fit({true, true, false, true});
    open();
    begin();
    uint64_t longest = 0;
    for (int i = 0; i < 300; ++i) {
        const uint64_t before_us = fakes::time_us();
        put(record(80));
        longest = std::max(longest, fakes::time_us() - before_us);
    }
    EXPECT_LE(longest, 42'000u);
}

TEST_F(Logs, any_byte_of_any_log_is_found_by_its_place) {
    for (unsigned pages : {1u, 7u, 2u, 40u, 3u}) writeLog(pages);
    std::mt19937 pick(3);
    for (int i = 0; i < 300; ++i) {
        const auto number = static_cast<uint16_t>(1 + pick() % 5);
        const auto offset = static_cast<uint32_t>(pick() % written[number].size());
        PageHead head;
        const uint16_t page = pageOf(number, offset, head);
        ASSERT_EQ(head.key.log, number);
        ASSERT_GE(offset, head.key.offset);
        ASSERT_LT(offset, head.key.offset + head.used);
        uint8_t byte;
        ASSERT_EQ(store.read(page, static_cast<uint16_t>(offset - head.key.offset), &byte, 1),
                  Status::ok);
        ASSERT_EQ(byte, written[number][offset]);
    }
    PageHead head;
    pageOf(4, UINT32_MAX, head);
    EXPECT_EQ(head.key.log, 4);
    EXPECT_EQ(head.key.offset + head.used, written[4].size());
}

// 500 bytes of a log, as the store writes them.
void putPage(uint8_t* at, const Key& key, int byte) {
    PageHead head = {key, 500, 0, 0};
    memset(at + sizeof head, byte, head.used);
    head.data_crc = core::crc16(core::kCrcStart, at + sizeof head, head.used);
    head.head_crc = crcOf(head);
    memcpy(at, &head, sizeof head);
}

// Wherever the newest page is: the first, the last, anywhere, before the ring is full and after.
TEST_F(Logs, the_end_of_a_full_chip_is_found_in_time_wherever_it_is) {
    chip::fit({true, false});  // the larger one
    open();
    const uint16_t all = ring();
    ASSERT_EQ(all, 8176);
    const uint16_t page_size = hal::flashShape().page_size;
    uint64_t longest_search_us = 0;
    for (const unsigned end :
         {1u, 2u, 100u, 4095u, 4096u, 8175u, 8176u, 8177u, 12000u, 16351u, 16352u, 16353u}) {
        // a log of 100 pages after the other, as this firmware would have written them
        std::vector<uint8_t> image(size_t{8192} * page_size, 0xFF);
        for (unsigned i = end > all ? end - all : 0; i < end; ++i) {
            putPage(&image[size_t{kFirst + i % all} * page_size],
                    {static_cast<uint16_t>(1 + i / 100), i % 100 * 500}, static_cast<int>(i));
        }
        ASSERT_TRUE(chip::model().setImage(image));
        chip::restart();
        const uint64_t took_us = open();
        EXPECT_EQ(store.last(), 1 + (end - 1) / 100) << end;
        EXPECT_EQ(store.pages(), end < all ? end : all - 1) << end;
        longest_search_us = std::max(longest_search_us, took_us);
        EXPECT_LT(longest_us, 400u) << "one look at a time";
        // the newest page is the last of what is read
        PageHead head;
        ASSERT_EQ(store.readHead(store.pages() - 1, head), Status::ok);
        EXPECT_EQ(head.key.log, 1 + (end - 1) / 100);
        EXPECT_EQ(head.key.offset, (end - 1) % 100 * 500);
    }
    EXPECT_LT(longest_search_us, 10'000u);
    RecordProperty("longest_search_us", static_cast<int>(longest_search_us));
}

// A log of 10 pages after the other, 65,530 the first, as this firmware would have written them.
TEST_F(Logs, behind_65535_comes_1_wherever_the_ring_then_is) {
    const uint16_t all = ring();
    const uint16_t page_size = hal::flashShape().page_size;
    const auto numberOf = [](unsigned page) {
        const unsigned number = 65530 + page / 10;
        return static_cast<uint16_t>(number > 65535 ? number - 65535 : number);
    };
    for (const unsigned end : {1u, 59u, 60u, 61u, 70u, 4000u, all + 3u, all + 60u, all + 75u}) {
        std::vector<uint8_t> image(size_t{4096} * page_size, 0xFF);
        for (unsigned i = end > all ? end - all : 0; i < end; ++i) {
            putPage(&image[size_t{kFirst + i % all} * page_size], {numberOf(i), i % 10 * 500},
                    static_cast<int>(i));
        }
        ASSERT_TRUE(chip::model().setImage(image));
        chip::restart();
        open();
        ASSERT_EQ(store.last(), numberOf(end - 1)) << end;
        ASSERT_EQ(store.pages(), end < all ? end : all - 1) << end;
        const unsigned oldest = end - store.pages();
        for (unsigned page = oldest; page < end; page += page < oldest + 100 ? 1 : 97) {
            PageHead head;
            ASSERT_EQ(pageOf(numberOf(page), page % 10 * 500, head), page - oldest);
            ASSERT_EQ(head.key.log, numberOf(page));
        }
        for (int i = 0; i < 8; ++i) {
            writeLog(2);
            ASSERT_EQ(store.last(), log) << end;
            ASSERT_EQ(readBack(log), written[log]) << end << ": " << log;
        }
        chip::restart();
        open();
        EXPECT_EQ(store.last(), log) << end;
    }
}

TEST_F(Logs, a_log_behind_65535_of_which_nothing_was_stored_has_no_number) {
    writeLog(1);
    std::vector<uint8_t> image = chip::model().image(fakes::time_us());
    PageHead head;
    uint8_t* const at = &image[size_t{kFirst} * hal::flashShape().page_size];
    memcpy(&head, at, sizeof head);
    head.key.log = 65535;
    head.head_crc = crcOf(head);
    memcpy(at, &head, sizeof head);
    ASSERT_TRUE(chip::model().setImage(image));
    chip::restart();
    open();
    ASSERT_EQ(store.last(), 65535);
    begin();
    EXPECT_EQ(store.last(), 65535);
    end();
    EXPECT_EQ(store.last(), 65535);
    writeLog(1);
    EXPECT_EQ(store.last(), 1);
}

TEST_F(Logs, a_full_chip_loses_its_oldest_log_and_nothing_else) {
    const unsigned per_log = 500;
    const unsigned logs = 2 * ring() / per_log + 2;
    for (unsigned i = 0; i < logs; ++i) {
        writeLog(per_log);
        if (written.size() > 12) written.erase(written.begin());
    }
    for (const bool restarted : {false, true}) {
        if (restarted) {
            chip::restart();
            open();
        }
        ASSERT_EQ(store.last(), logs);
        const unsigned whole = (ring() - 1) / per_log;
        for (unsigned number = logs - whole + 1; number <= logs; ++number)
            EXPECT_EQ(readBack(static_cast<uint16_t>(number)),
                      written[static_cast<uint16_t>(number)])
                << number;
        // of the one before, the end
        uint32_t first = 0;
        const auto cut = static_cast<uint16_t>(logs - whole);
        const Bytes rest = readBack(cut, &first);
        EXPECT_GT(first, 0u);
        EXPECT_TRUE(std::equal(rest.begin(), rest.end(), written[cut].begin() + first));
    }
    const simulator::At45db& model = chip::model();
    uint32_t most = 0, least = UINT32_MAX;
    for (uint16_t page = kFirst; page < hal::flashShape().pages; ++page) {
        most = std::max(most, model.erases(page));
        least = std::min(least, model.erases(page));
    }
    EXPECT_LE(most - least, 1u) << "every page wears alike";
    for (uint16_t page = 0; page < kFirst; ++page) EXPECT_EQ(model.programs(page), 0u);
}

// At every page of three logs, and with the next turn of the ring about to begin.
class PowerCut : public Logs, public testing::WithParamInterface<unsigned> {};

TEST_P(PowerCut, loses_only_the_page_being_written) {
    // so many pages lie in the ring before
    begin();
    for (unsigned i = 0; i < GetParam(); ++i) put(record(200)), put(record(200)), put(record(100));
    end();
    const Bytes before = written[1];

    for (int cut = 0; cut < 40; ++cut) {
        SCOPED_TRACE(cut);
        std::vector<simulator::At45db::Operation> stores;
        chip::model().on_operation = [&](const simulator::At45db::Operation& each) {
            stores.push_back(each);
        };
        begin();
        const uint16_t number = log;
        const size_t pages = 1 + random() % 3;
        while (stores.size() < pages) put(record(static_cast<uint8_t>(20 + random() % 200)));
        // somewhere in the programming of that page
        const simulator::At45db::Operation last = stores.back();
        if (fakes::time_us() < last.end_us)
            fakes::advance_us(random() % (last.end_us - fakes::time_us() + 1));
        const bool damaged = fakes::time_us() < last.end_us;
        chip::cutPower();
        open();

        const size_t stored = pages - (damaged ? 1 : 0);
        ASSERT_EQ(store.last(), stored > 0 ? number : number - 1);
        const Bytes left = readBack(number);
        EXPECT_TRUE(isBeginningOf(left, written[number]));
        EXPECT_GE(left.size() + 2 * room(), written[number].size());
        if (GetParam() > 0 && GetParam() < ring() / 2u) {
            EXPECT_EQ(readBack(1), before);
        }
        if (number > 2 && cut > 1) {
            EXPECT_TRUE(isBeginningOf(readBack(number - 1), written[number - 1]));
        }
        chip::model().on_operation = nullptr;
        written.erase(number + 1);
    }
}

INSTANTIATE_TEST_SUITE_P(places, PowerCut, testing::Values(0u, 1u, 300u, 4070u, 4079u, 4080u));

TEST_F(Logs, an_erase_leaves_nothing_and_lets_the_ring_begin_elsewhere) {
    writeLog(30);
    ASSERT_TRUE(store.erase());
    uint64_t longest = 0;
    while (store.erasing()) {
        const uint64_t before_us = fakes::time_us();
        if (store.eraseStep()) {
            EXPECT_EQ(store.nextBase(), 32);
            store.finishErase();
        }
        longest = std::max(longest, fakes::time_us() - before_us);
        fakes::advance_ms(20);
    }
    EXPECT_LT(longest, 200u) << "in the background";
    EXPECT_EQ(store.last(), 0);
    EXPECT_EQ(store.pages(), 0);
    const uint32_t erased = chip::model().erases(kFirst);
    writeLog(2);
    EXPECT_EQ(chip::model().erases(kFirst), erased) << "where the next log begins";
    EXPECT_EQ(readBack(1), written[1]);

    chip::restart();
    open(32);
    EXPECT_EQ(store.last(), 1);
    EXPECT_EQ(readBack(1), written[1]);
}

TEST_F(Logs, a_log_that_begins_stops_the_erase_and_keeps_what_is_left) {
    for (int i = 0; i < 5; ++i) writeLog(1000);  // the ring is full
    ASSERT_TRUE(store.erase());
    const unsigned steps = (ring() / 8) / 2;
    for (unsigned i = 0; i < 2000 && store.erasing() && i < steps * 5; ++i) {
        store.eraseStep();
        fakes::advance_ms(20);
    }
    ASSERT_TRUE(store.erasing());
    writeLog(4);

    const Bytes now = readBack(log);
    EXPECT_EQ(now, written[log]);
    const uint16_t last = store.last();
    chip::restart();
    open();
    EXPECT_EQ(store.last(), last);
    EXPECT_EQ(readBack(last), written[last]);
}

TEST_F(Logs, a_power_cut_during_the_erase_leaves_logs_that_can_be_read_and_added_to) {
    for (int i = 0; i < 5; ++i) writeLog(1000);
    const std::map<uint16_t, Bytes> before = written;
    ASSERT_TRUE(store.erase());
    for (int i = 0; i < 700; ++i) {
        store.eraseStep();
        fakes::advance_ms(20);
    }
    ASSERT_TRUE(store.erasing());
    chip::cutPower();
    open();
    for (uint16_t number = 1; number <= store.last(); ++number) {
        uint32_t first = 0;
        const Bytes left = readBack(number, &first);
        ASSERT_LE(first + left.size(), before.at(number).size());
        EXPECT_TRUE(std::equal(left.begin(), left.end(), before.at(number).begin() + first));
    }
    writeLog(3);
    EXPECT_EQ(readBack(log), written[log]);
}

TEST_F(Logs, the_mission_goes_first_and_nothing_is_lost) {
    begin();
    for (int i = 0; i < 100; ++i) {
        chip::wantByMission(i % 10 != 0);
        uint8_t byte[60];
        memset(byte, i, sizeof byte);
        if (store.put(byte, sizeof byte) == Status::ok)
            written[log].insert(written[log].end(), byte, byte + sizeof byte);
        fakes::advance_ms(10);
    }
    chip::wantByMission(false);
    end();
    EXPECT_EQ(readBack(log), written[log]);
    EXPECT_GT(written[log].size(), 3000u);
}

TEST_F(Logs, a_corrupt_page_hides_only_itself) {
    writeLog(200);
    std::vector<uint8_t> image = chip::model().image(fakes::time_us());
    for (const unsigned page : {64u, 100u, 127u})  // where the search looks
        memset(&image[size_t{kFirst + page} * hal::flashShape().page_size], 0x5A, 100);
    ASSERT_TRUE(chip::model().setImage(image));
    chip::restart();
    open();
    EXPECT_EQ(store.last(), 1);
    EXPECT_EQ(store.pages(), 200);
}

}  // namespace
