// SPDX-License-Identifier: GPL-3.0-or-later
// Logs as they are handed out: in pieces of any size from anywhere, with the formats in front where
// the ring has overwritten the beginning.
#include "logging/reader.hpp"

#include "logs.hpp"

using namespace chip;

namespace {

constexpr logging::Format kRows[] = {
    {128, 89, "FMT", "BBnNZ", "Type,Length,Name,Format,Columns"},
    {129, 12, "ONE", "QB", "TimeUS,Id"},
};
constexpr logging::Formats kFormats = {
    [](uint8_t index, logging::Format& to) { to = kRows[index]; }, 2};
constexpr size_t kInFront = 2 * sizeof(logging::FormatRecord);

class Reading : public Logs {
protected:
    uint32_t sizeOf(uint16_t number, Status expected = Status::ok) {
        reader.open(store, number);
        uint32_t size = 0;
        Status status = Status::busy;
        for (int i = 0; i < 100 && status == Status::busy; ++i) {
            status = reader.size(store, kFormats, size);
            fakes::advance_us(100);
        }
        EXPECT_EQ(status, expected);
        return size;
    }
    Bytes take(uint32_t at, uint8_t size) {
        Bytes bytes(size);
        Status status = Status::busy;
        for (int i = 0; i < 100 && status == Status::busy; ++i) {
            uint8_t got = size;
            status = reader.read(store, kFormats, at, bytes.data(), got);
            if (status == Status::ok) bytes.resize(got);
            fakes::advance_us(100);
        }
        EXPECT_EQ(status, Status::ok) << at;
        EXPECT_GT(bytes.size(), 0u);
        return bytes;
    }
    Bytes whole(uint16_t number) {
        Bytes bytes;
        for (uint32_t size = sizeOf(number); bytes.size() < size;) {
            const auto left = std::min<uint32_t>(90, size - static_cast<uint32_t>(bytes.size()));
            const Bytes part =
                take(static_cast<uint32_t>(bytes.size()), static_cast<uint8_t>(left));
            bytes.insert(bytes.end(), part.begin(), part.end());
        }
        return bytes;
    }

    logging::Reader reader;
};

TEST_F(Reading, a_log_comes_as_it_was_written) {
    for (unsigned pages : {3u, 1u, 20u}) writeLog(pages);
    for (uint16_t number = 1; number <= 3; ++number) {
        EXPECT_EQ(sizeOf(number), written[number].size());
        EXPECT_EQ(whole(number), written[number]);
    }
}

TEST_F(Reading, a_missing_log_is_reported) {
    sizeOf(1, Status::corrupt);
    writeLog(2);
    sizeOf(2, Status::corrupt);
    sizeOf(0, Status::corrupt);
}

TEST_F(Reading, any_piece_may_be_asked_for_in_any_order) {
    for (unsigned pages : {3u, 50u, 2u}) writeLog(pages);
    std::mt19937 pick(5);
    sizeOf(2);
    for (int i = 0; i < 500; ++i) {
        const auto at = static_cast<uint32_t>(pick() % (written[2].size() - 90));
        const Bytes part = take(at, 90);
        ASSERT_TRUE(std::equal(part.begin(), part.end(), written[2].begin() + at)) << at;
    }
}

TEST_F(Reading, the_formats_stand_in_front_of_a_log_without_its_beginning) {
    for (int i = 0; i < 4; ++i) writeLog(1500);  // the first are overwritten, the second in part
    uint32_t cut = 0;
    const Bytes rest = readBack(2, &cut);
    ASSERT_GT(cut, 0u);
    EXPECT_EQ(sizeOf(2), rest.size() + kInFront);

    const Bytes handed_out = whole(2);
    for (size_t row = 0; row < 2; ++row) {
        logging::FormatRecord record;
        memcpy(&record, &handed_out[row * sizeof record], sizeof record);
        EXPECT_EQ(record.head.head1, 0xA3);
        EXPECT_EQ(record.head.head2, 0x95);
        EXPECT_EQ(record.head.type, 128);
        EXPECT_EQ(memcmp(&record.format, &kRows[row], sizeof kRows[row]), 0);
    }
    EXPECT_EQ(Bytes(handed_out.begin() + kInFront, handed_out.end()), rest);
    EXPECT_EQ(whole(3), written[3]);
    // a piece over the seam ends there and goes on with the next
    sizeOf(2);
    EXPECT_EQ(take(kInFront - 10, 90).size(), 10u);
}

TEST_F(Reading, an_unreadable_page_is_sent_as_zeros) {
    writeLog(10);
    std::vector<uint8_t> image = chip::model().image(fakes::time_us());
    memset(&image[size_t{kFirst + 4u} * hal::flashShape().page_size], 0x5A, 100);
    ASSERT_TRUE(chip::model().setImage(image));
    chip::restart();
    open();

    const Bytes handed_out = whole(1);
    ASSERT_EQ(handed_out.size(), written[1].size());
    const size_t page = written[1].size() / 10;
    EXPECT_TRUE(std::equal(handed_out.begin(), handed_out.begin() + 4 * page, written[1].begin()));
    EXPECT_EQ(std::count(handed_out.begin() + 4 * page, handed_out.begin() + 5 * page, 0), page);
    EXPECT_TRUE(std::equal(handed_out.begin() + 5 * page + 90, handed_out.end(),
                           written[1].begin() + 5 * page + 90));
}

TEST_F(Reading, no_step_takes_longer_than_half_a_millisecond) {
    for (int i = 0; i < 4; ++i) writeLog(1500);
    reader.open(store, 3);
    uint32_t size = 0;
    uint64_t longest = 0;
    const auto step = [&](auto what) {
        const uint64_t before_us = fakes::time_us();
        const Status status = what();
        longest = std::max(longest, fakes::time_us() - before_us);
        return status;
    };
    while (step([&] { return reader.size(store, kFormats, size); }) == Status::busy) {
    }
    for (uint32_t at = 0; at < 20'000;) {
        uint8_t bytes[90], got = sizeof bytes;
        const Status status = step([&] { return reader.read(store, kFormats, at, bytes, got); });
        if (status == Status::ok) at += got;
    }
    EXPECT_LT(longest, 500u);  // of the bus alone, 2 us a byte
}

}  // namespace
