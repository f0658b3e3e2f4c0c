// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/at45db.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>

using namespace simulator;
using Bytes = std::vector<uint8_t>;

namespace {

constexpr uint8_t kStatus = 0xD7, kIdentity = 0x9F;

// The chip's user: whole transactions, a microsecond a byte.
struct Bench {
    explicit Bench(At45dbOptions options = {}) : chip(1, options) {
        chip.on_operation = [this](const At45db::Operation& begun) { operations.push_back(begun); };
    }
    Bytes exchange(const Bytes& out, size_t in = 0) {
        chip.select(true, now_us);
        for (const uint8_t byte : out) chip.transfer(byte, ++now_us);
        Bytes heard;
        for (size_t i = 0; i < in; ++i) heard.push_back(chip.transfer(0, ++now_us));
        chip.select(false, now_us);
        return heard;
    }
    // opcode, page and byte, then what else is to be sent
    Bytes at(uint8_t opcode, unsigned page, unsigned byte, const Bytes& more = {}) const {
        const unsigned address = page << (chip.pageSize() == 512 ? 9 : 10) | byte;
        Bytes out = {opcode};
        for (const int shift : {16, 8, 0}) out.push_back(static_cast<uint8_t>(address >> shift));
        for (const uint8_t each : more) out.push_back(each);
        return out;
    }
    Bytes read(unsigned page, unsigned byte, size_t size) {
        return exchange(at(0xD2, page, byte, {0, 0, 0, 0}), size);
    }
    bool ready() { return exchange({kStatus}, 1)[0] & 0x80; }
    // How long it is busy from now on, to 10 us.
    uint64_t busy_us() {
        const uint64_t begin_us = now_us;
        while (!ready() && now_us - begin_us < 10'000'000) now_us += 10;
        return now_us - begin_us;
    }
    void fill(int buffer, const Bytes& bytes, unsigned from = 0) {
        exchange(at(buffer ? 0x87 : 0x84, 0, from, bytes));
    }
    void store(int buffer, unsigned page) { exchange(at(buffer ? 0x86 : 0x83, page, 0)); }
    void put(unsigned page, const Bytes& bytes) {
        fill(0, bytes);
        store(0, page);
        busy_us();
    }
    Bytes whole(unsigned page) const {
        return Bytes(chip.page(static_cast<uint16_t>(page)),
                     chip.page(static_cast<uint16_t>(page)) + chip.pageSize());
    }

    At45db chip;
    uint64_t now_us = 1000;
    std::vector<At45db::Operation> operations;
};

Bytes pattern(size_t size, int seed) {
    Bytes bytes(size);
    for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(seed = (seed * 75 + 74) % 65537);
    return bytes;
}

At45dbOptions the161d() {
    At45dbOptions options;
    options.is_161d = true;
    return options;
}

At45dbOptions slow() {
    At45dbOptions options;
    options.slowest = true;
    return options;
}

}  // namespace

TEST(At45dbModel, says_who_it_is) {
    Bench of_32_megabits, of_16_megabits(the161d());

    EXPECT_EQ(of_32_megabits.exchange({kIdentity}, 4), (Bytes{0x1F, 0x27, 0x01, 0x00}));
    EXPECT_EQ(of_16_megabits.exchange({kIdentity}, 4), (Bytes{0x1F, 0x26, 0x00, 0x00}));
    EXPECT_EQ(of_32_megabits.exchange({kStatus}, 2), (Bytes{0xB4, 0xB4}));
    EXPECT_EQ(of_16_megabits.exchange({kStatus}, 1), (Bytes{0xAC}));
}

TEST(At45dbModel, is_blank_when_new) {
    Bench bench;

    EXPECT_EQ(bench.read(8191, 0, 528), Bytes(528, 0xFF));
}

TEST(At45dbModel, keeps_what_is_stored_and_wraps_in_the_page) {
    Bench bench;
    const Bytes page = pattern(528, 1);
    bench.put(4711, page);

    EXPECT_EQ(bench.read(4711, 0, 528), page);
    EXPECT_EQ(bench.read(4711, 526, 4), (Bytes{page[526], page[527], page[0], page[1]}));
    EXPECT_EQ(bench.read(4710, 0, 528), Bytes(528, 0xFF));
}

TEST(At45dbModel, a_buffer_wraps_and_the_two_are_apart) {
    Bench bench;
    bench.fill(0, Bytes(528, 1));
    bench.fill(1, Bytes(528, 2));
    bench.fill(0, {7, 8, 9}, 526);

    EXPECT_EQ(bench.exchange(bench.at(0xD4, 0, 525, {0}), 5), (Bytes{1, 7, 8, 9, 1}));
    EXPECT_EQ(bench.exchange(bench.at(0xD3, 0, 525), 5), (Bytes{2, 2, 2, 2, 2}));
}

TEST(At45dbModel, an_array_read_goes_on_over_pages_and_around_the_end) {
    Bench bench;
    bench.put(8191, Bytes(528, 5));
    bench.put(0, Bytes(528, 6));

    EXPECT_EQ(bench.exchange(bench.at(0x03, 8191, 526), 4), (Bytes{5, 5, 6, 6}));
    EXPECT_EQ(bench.exchange(bench.at(0x0B, 8191, 527, {0}), 2), (Bytes{5, 6}));
    EXPECT_EQ(bench.exchange(bench.at(0xE8, 8191, 527, {0, 0, 0, 0}), 2), (Bytes{5, 6}));
}

TEST(At45dbModel, a_store_without_erase_can_only_clear_bits) {
    Bench bench;
    bench.put(3, Bytes(528, 0x0F));
    bench.fill(1, Bytes(528, 0x3C));
    bench.exchange(bench.at(0x89, 3, 0));
    bench.busy_us();

    EXPECT_EQ(bench.whole(3), Bytes(528, 0x0C));
}

TEST(At45dbModel, goes_by_page_through_a_buffer) {
    Bench bench;
    bench.put(9, pattern(528, 2));
    bench.fill(0, Bytes(528, 0));

    bench.exchange(bench.at(0x53, 9, 0));
    bench.busy_us();
    bench.exchange(bench.at(0x60, 9, 0));
    bench.busy_us();
    EXPECT_EQ(bench.exchange({kStatus}, 1)[0] & 0x40, 0) << "the same";

    bench.exchange(bench.at(0x82, 9, 100, {1, 2, 3}));
    bench.busy_us();
    Bytes wanted = pattern(528, 2);
    std::iota(wanted.begin() + 100, wanted.begin() + 103, uint8_t{1});
    EXPECT_EQ(bench.whole(9), wanted);

    bench.exchange(bench.at(0x61, 9, 0));
    bench.busy_us();
    EXPECT_EQ(bench.exchange({kStatus}, 1)[0] & 0x40, 0x40) << "buffer 2 is another";
}

struct Duration {
    uint8_t opcode;
    uint64_t typical_us, longest_us;
};
class At45dbTimes : public testing::TestWithParam<Duration> {};

TEST_P(At45dbTimes, are_the_datasheets) {
    Bench typical, longest(slow());
    typical.exchange(typical.at(GetParam().opcode, 64, 0));
    longest.exchange(longest.at(GetParam().opcode, 64, 0));

    EXPECT_NEAR(static_cast<double>(typical.busy_us()), static_cast<double>(GetParam().typical_us),
                15);
    EXPECT_NEAR(static_cast<double>(longest.busy_us()), static_cast<double>(GetParam().longest_us),
                15);
}

INSTANTIATE_TEST_SUITE_P(All, At45dbTimes,
                         testing::Values(Duration{0x83, 17'000, 40'000},
                                         Duration{0x88, 3'000, 6'000},
                                         Duration{0x81, 15'000, 35'000},
                                         Duration{0x50, 45'000, 100'000},
                                         Duration{0x7C, 1'600'000, 5'000'000},
                                         Duration{0x53, 200, 200}, Duration{0x60, 200, 200}));

TEST(At45dbModel, erases_a_page_a_block_a_sector) {
    Bench bench;
    for (const unsigned page : {15u, 16u, 23u, 24u, 7u, 8u, 127u, 128u})
        bench.put(page, Bytes(528, 0));

    bench.exchange(bench.at(0x81, 15, 0));
    bench.busy_us();
    EXPECT_EQ(bench.whole(15), Bytes(528, 0xFF));
    EXPECT_EQ(bench.whole(16), Bytes(528, 0));

    bench.exchange(bench.at(0x50, 19, 0));
    bench.busy_us();
    EXPECT_EQ(bench.whole(16), Bytes(528, 0xFF));
    EXPECT_EQ(bench.whole(23), Bytes(528, 0xFF));
    EXPECT_EQ(bench.whole(24), Bytes(528, 0));

    bench.exchange(bench.at(0x7C, 100, 0));
    bench.busy_us();
    EXPECT_EQ(bench.whole(7), Bytes(528, 0)) << "sector 0 is cut after its first block";
    EXPECT_EQ(bench.whole(8), Bytes(528, 0xFF));
    EXPECT_EQ(bench.whole(127), Bytes(528, 0xFF));
    EXPECT_EQ(bench.whole(128), Bytes(528, 0));
}

TEST(At45dbModel, accepts_only_status_identity_and_the_other_buffer_while_busy) {
    Bench bench;
    bench.put(5, Bytes(528, 5));
    bench.fill(0, Bytes(528, 1));
    bench.fill(1, Bytes(528, 2));
    const uint64_t before = bench.chip.ignored();
    bench.store(0, 6);

    EXPECT_EQ(bench.read(5, 0, 1), (Bytes{0xFF}));
    bench.store(1, 7);
    bench.fill(0, {9});
    EXPECT_EQ(bench.chip.ignored() - before, 3u);
    bench.fill(1, {8});
    EXPECT_EQ(bench.exchange({kIdentity}, 1), (Bytes{0x1F}));
    EXPECT_EQ(bench.chip.ignored() - before, 3u);

    bench.busy_us();
    EXPECT_EQ(bench.whole(6), Bytes(528, 1));
    EXPECT_EQ(bench.whole(7), Bytes(528, 0xFF));
    EXPECT_EQ(bench.exchange(bench.at(0xD4, 0, 0, {0}), 1), (Bytes{1}));
    EXPECT_EQ(bench.exchange(bench.at(0xD6, 0, 0, {0}), 1), (Bytes{8}));
}

TEST(At45dbModel, the_other_buffer_may_be_filled_bit_by_bit_while_busy) {
    Bench bench;
    bench.fill(0, Bytes(528, 1));
    const uint64_t before = bench.chip.ignored();
    bench.store(0, 6);

    bench.fill(1, {7});
    bench.fill(1, {8}, 1);
    EXPECT_EQ(bench.chip.ignored() - before, 0u);
    bench.fill(0, {9});
    EXPECT_EQ(bench.chip.ignored() - before, 1u);

    bench.busy_us();
    EXPECT_EQ(bench.exchange(bench.at(0xD6, 0, 0, {0}), 2), (Bytes{7, 8}));
    EXPECT_EQ(bench.whole(6), Bytes(528, 1));
}

TEST(At45dbModel, does_nothing_with_half_a_command) {
    Bench bench;
    bench.exchange({0x83, 0, 0});
    bench.exchange({0xC7, 0x94, 0x80, 0x9B});
    bench.exchange({0x00, 1, 2, 3});

    EXPECT_TRUE(bench.operations.empty());
    EXPECT_TRUE(bench.ready());
}

TEST(At45dbModel, reports_each_program_and_erase_and_counts_the_wear) {
    Bench bench;
    bench.store(1, 77);
    bench.busy_us();
    bench.exchange(bench.at(0x50, 72, 0));

    ASSERT_EQ(bench.operations.size(), 2u);
    EXPECT_TRUE(bench.operations[0].programs);
    EXPECT_EQ(bench.operations[0].first_page, 77);
    EXPECT_EQ(bench.operations[0].end_us - bench.operations[0].begin_us, 17'000u);
    EXPECT_FALSE(bench.operations[1].programs);
    EXPECT_EQ(bench.operations[1].first_page, 72);
    EXPECT_EQ(bench.operations[1].pages, 8);
    EXPECT_EQ(bench.chip.programs(77), 1u);
    EXPECT_EQ(bench.chip.erases(77), 2u);
    EXPECT_EQ(bench.chip.erases(72), 1u);
    EXPECT_EQ(bench.chip.erases(80), 0u);
}

TEST(At45dbModel, a_power_cut_damages_the_page_at_work_and_no_other) {
    for (unsigned page = 20; page < 40; ++page) {
        Bench bench;
        for (unsigned i = 19; i < 42; ++i) bench.put(i, pattern(528, static_cast<int>(i)));
        bench.fill(0, pattern(528, 999));
        bench.store(0, page);
        bench.now_us += 16'000;
        const Bytes reported = bench.chip.image(bench.now_us);
        bench.chip.cutPower(bench.now_us);

        EXPECT_NE(bench.whole(page), pattern(528, 999));
        EXPECT_EQ(bench.whole(page - 1), pattern(528, static_cast<int>(page - 1)));
        EXPECT_EQ(bench.whole(page + 1), pattern(528, static_cast<int>(page + 1)));
        EXPECT_EQ(bench.chip.image(bench.now_us), reported);
        EXPECT_TRUE(bench.ready());
    }
}

TEST(At45dbModel, a_power_cut_after_the_work_damages_nothing_but_the_buffers) {
    Bench bench;
    bench.put(20, pattern(528, 3));
    bench.chip.cutPower(bench.now_us);

    EXPECT_EQ(bench.whole(20), pattern(528, 3));
    EXPECT_NE(bench.exchange(bench.at(0xD4, 0, 0, {0}), 528), pattern(528, 3));
}

TEST(At45dbModel, a_power_cut_leaves_pages_in_many_states) {
    int noise = 0, erased = 0, begun = 0;
    for (unsigned i = 0; i < 60; ++i) {
        Bench bench;
        for (unsigned k = 0; k < i; ++k) bench.put(k, {1});  // another cut each time
        bench.fill(0, Bytes(528, 0x55));
        bench.store(0, 300);
        bench.chip.cutPower(bench.now_us);
        const Bytes left = bench.whole(300);
        const auto blank = std::count(left.begin(), left.end(), 0xFF);
        const auto wanted = std::count(left.begin(), left.end(), 0x55);
        erased += blank > 520;
        begun += wanted > 50;
        noise += blank < 50 && wanted < 50;
    }
    EXPECT_GT(noise, 3);
    EXPECT_GT(erased, 3);
    EXPECT_GT(begun, 3);
}

TEST(At45dbModel, the_reset_pin_stops_the_work_as_a_cut_does) {
    Bench bench;
    bench.fill(0, pattern(528, 4));
    bench.store(0, 30);
    bench.chip.resetPin(true, bench.now_us);
    EXPECT_EQ(bench.exchange({kIdentity}, 1), (Bytes{0xFF})) << "it is held";
    bench.chip.resetPin(false, bench.now_us);

    EXPECT_TRUE(bench.ready());
    EXPECT_NE(bench.whole(30), pattern(528, 4));
    EXPECT_EQ(bench.exchange(bench.at(0xD4, 0, 0, {0}), 528), pattern(528, 4)) << "buffers stay";
}

TEST(At45dbModel, an_image_restores_all_pages_and_identifies_its_chip) {
    Bench first(the161d());
    first.put(100, pattern(528, 5));
    Bench second;

    EXPECT_TRUE(second.chip.setImage(first.chip.image(first.now_us)));
    EXPECT_EQ(second.chip.pages(), 4096);
    EXPECT_EQ(second.read(100, 0, 528), pattern(528, 5));
    EXPECT_TRUE(second.chip.setImage(Bytes(8192 * 512)));
    EXPECT_EQ(second.exchange({kStatus}, 1), (Bytes{0xB5}));
    EXPECT_FALSE(second.chip.setImage(Bytes(1000)));
}

TEST(At45dbModel, the_page_size_changes_for_ever_at_the_next_power_on) {
    Bench bench;
    bench.put(2, pattern(528, 6));
    bench.exchange({0x3D, 0x2A, 0x80, 0xA6});
    bench.busy_us();
    EXPECT_EQ(bench.chip.pageSize(), 528);

    bench.chip.cutPower(bench.now_us);
    EXPECT_EQ(bench.chip.pageSize(), 512);
    const Bytes was = pattern(528, 6);
    EXPECT_EQ(bench.read(2, 0, 512), Bytes(was.begin(), was.begin() + 512));
}

TEST(At45dbModel, sleeps_until_it_is_woken) {
    Bench bench;
    bench.exchange({0xB9});
    EXPECT_EQ(bench.exchange({kIdentity}, 1), (Bytes{0xFF}));
    bench.exchange({0xAB});
    EXPECT_EQ(bench.exchange({kIdentity}, 1), (Bytes{0x1F}));
}

TEST(At45dbModel, there_is_no_answer_where_none_is_fitted) {
    At45dbOptions options;
    options.fitted = false;
    Bench bench(options);

    EXPECT_EQ(bench.exchange({kIdentity}, 4), Bytes(4, 0xFF));
    EXPECT_EQ(bench.exchange({kStatus}, 1), (Bytes{0xFF}));
}
