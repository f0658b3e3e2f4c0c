// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/at45db.hpp"

#include <gmock/gmock.h>

#include <memory>

#include "fakes/flash_bus.hpp"
#include "simulator/devices/at45db.hpp"

using core::Status;
using drivers::At45dbTrouble;
using fakes::FlashBus;
using testing::ElementsAre;
using Bytes = std::vector<uint8_t>;

namespace {

using Driver = drivers::At45db<FlashBus, fakes::FlashSelect, fakes::FlashReset>;

Bytes pattern(size_t size, int seed) {
    Bytes bytes(size);
    for (uint8_t& byte : bytes) byte = static_cast<uint8_t>(seed = (seed * 75 + 74) % 65537);
    return bytes;
}

// The driver alone: the bus answers from a script and keeps what was sent, by transaction.
struct Scripted : testing::Test {
    Scripted() {
        FlashBus::reset();
        FlashBus::on_select = [this](bool low) {
            if (low) transactions.emplace_back();
        };
        FlashBus::on_reset = [this](bool low) {
            if (low) resets_ms.push_back(now_ms);
            reset_low = low;
        };
        FlashBus::device = [this](uint8_t out) {
            Bytes& sent = transactions.back();
            sent.push_back(out);
            if (sent.size() == 1) return uint8_t{0xFF};
            if (sent[0] == 0xD7) return status;
            if (sent[0] == 0x9F) return identity.at(sent.size() - 2);
            return static_cast<uint8_t>(sent.size());
        };
    }
    ~Scripted() override { FlashBus::reset(); }
    void start() {
        driver.start(now_ms);
        for (int i = 0; i < 20; ++i) driver.step(now_ms = static_cast<uint16_t>(now_ms + 10));
        transactions.clear();
    }

    Driver driver;
    std::vector<Bytes> transactions;
    uint8_t status = 0xB4;
    Bytes identity = {0x1F, 0x27};
    uint16_t now_ms = 65500;  // wraps soon
    std::vector<uint16_t> resets_ms;
    bool reset_low = false;
    uint8_t bytes[255] = {};
};

// The driver on the simulator's chip: a byte takes a microsecond.
struct OnModel : testing::Test {
    OnModel() { put({}); }
    ~OnModel() override { FlashBus::reset(); }
    void put(simulator::At45dbOptions options) {
        FlashBus::reset();
        chip = std::make_unique<simulator::At45db>(1, options);
        FlashBus::on_select = [this](bool low) { chip->select(low, now_us); };
        FlashBus::on_reset = [this](bool low) { chip->resetPin(low, now_us); };
        FlashBus::device = [this](uint8_t out) { return chip->transfer(out, ++now_us); };
    }
    uint16_t now_ms() const { return static_cast<uint16_t>(now_us / 1000); }
    void start() {
        driver.start(now_ms());
        for (int i = 0; i < 30 && !driver.known(); ++i) wait_ms(10);
    }
    void wait_ms(int ms) {
        now_us += static_cast<uint64_t>(ms) * 1000;
        driver.step(now_ms());
    }
    Status read(uint16_t page, uint16_t offset, uint8_t size) {
        read_bytes.assign(size, 0);
        return driver.read(page, offset, read_bytes.data(), size, now_ms());
    }
    Status fill(uint8_t buffer, uint16_t offset, const Bytes& bytes) {
        return driver.fill(buffer, offset, bytes.data(), static_cast<uint8_t>(bytes.size()),
                           now_ms());
    }
    Status store(uint8_t buffer, uint16_t page) { return driver.store(buffer, page, now_ms()); }

    std::unique_ptr<simulator::At45db> chip;
    Driver driver;
    uint64_t now_us = 3000;
    Bytes read_bytes;
};

}  // namespace

TEST_F(Scripted, asks_who_is_there_after_a_reset_of_a_millisecond_at_least) {
    driver.start(now_ms);
    for (int tick = 0; tick < 3; ++tick) {  // the first two may come at once
        EXPECT_TRUE(reset_low);
        driver.step(++now_ms);
    }
    EXPECT_FALSE(reset_low);
    EXPECT_FALSE(driver.known());
    driver.step(++now_ms);

    EXPECT_TRUE(driver.known());
    EXPECT_EQ(driver.trouble(), At45dbTrouble::none);
    EXPECT_EQ(driver.pages(), 8192);
    EXPECT_EQ(driver.pageSize(), 528);
    EXPECT_EQ(resets_ms.size(), 1u);
}

TEST_F(Scripted, lets_a_chip_that_is_busy_at_start_finish_before_it_resets_it) {
    status = 0x34;
    driver.start(now_ms);
    driver.step(now_ms = static_cast<uint16_t>(now_ms + 90));
    EXPECT_FALSE(reset_low);
    status = 0xB4;
    driver.step(++now_ms);
    EXPECT_TRUE(reset_low);
}

TEST_F(Scripted, resets_a_chip_that_does_not_finish) {
    status = 0x34;
    driver.start(now_ms);
    driver.step(now_ms = static_cast<uint16_t>(now_ms + 102));

    EXPECT_TRUE(reset_low);
}

struct Chip {
    Bytes identity;
    uint8_t status;
    uint16_t pages, page_size;
};
class KnownChip : public Scripted, public testing::WithParamInterface<Chip> {};

TEST_P(KnownChip, is_known_by_its_identity_and_its_status) {
    identity = GetParam().identity;
    status = GetParam().status;
    start();

    EXPECT_EQ(driver.pages(), GetParam().pages);
    if (GetParam().pages > 0) {
        EXPECT_EQ(driver.pageSize(), GetParam().page_size);
    }
    EXPECT_EQ(driver.trouble(), GetParam().pages ? At45dbTrouble::none : At45dbTrouble::absent);
}

INSTANTIATE_TEST_SUITE_P(
    All, KnownChip,
    testing::Values(Chip{{0x1F, 0x27}, 0xB4, 8192, 528}, Chip{{0x1F, 0x27}, 0xB5, 8192, 512},
                    Chip{{0x1F, 0x26}, 0xAC, 4096, 528}, Chip{{0x1F, 0x26}, 0xAD, 4096, 512},
                    Chip{{0x1F, 0x26}, 0xB4, 0, 0}, Chip{{0x1F, 0x25}, 0x9C, 0, 0},
                    Chip{{0xC2, 0x27}, 0xB4, 0, 0}, Chip{{0xFF, 0xFF}, 0xFF, 0, 0},
                    Chip{{0x00, 0x00}, 0x00, 0, 0}));

TEST_F(Scripted, addresses_pages_of_528_with_ten_bits_for_the_byte) {
    start();

    ASSERT_EQ(driver.read(8191, 517, bytes, 2, now_ms), Status::ok);
    EXPECT_THAT(transactions.back(), ElementsAre(0xD2, 0x7F, 0xFE, 0x05, 0, 0, 0, 0, 0, 0));
    EXPECT_THAT(Bytes(bytes, bytes + 3), ElementsAre(9, 10, 0));
    bytes[0] = 0xAA;
    ASSERT_EQ(driver.fill(1, 257, bytes, 1, now_ms), Status::ok);
    EXPECT_THAT(transactions.back(), ElementsAre(0x87, 0, 1, 1, 0xAA));
    ASSERT_EQ(driver.store(1, 4097, now_ms), Status::ok);
    EXPECT_THAT(transactions.back(), ElementsAre(0x86, 0x40, 0x04, 0x00));
}

TEST_F(Scripted, addresses_pages_of_512_with_nine) {
    status = 0xB5;
    start();

    ASSERT_EQ(driver.read(8191, 511, bytes, 1, now_ms), Status::ok);
    EXPECT_THAT(transactions.back(), ElementsAre(0xD2, 0x3F, 0xFF, 0xFF, 0, 0, 0, 0, 0));
    ASSERT_EQ(driver.eraseBlock(16, now_ms), Status::ok);
    EXPECT_THAT(transactions.back(), ElementsAre(0x50, 0x00, 0x20, 0x00));
    ASSERT_EQ(driver.erasePage(9, now_ms), Status::ok);
    EXPECT_THAT(transactions.back(), ElementsAre(0x81, 0x00, 0x12, 0x00));
}

TEST_F(Scripted, refuses_what_lies_outside_of_page_or_chip) {
    start();

    EXPECT_EQ(driver.read(8192, 0, bytes, 1, now_ms), Status::bad_argument);
    EXPECT_EQ(driver.read(0, 528, bytes, 1, now_ms), Status::bad_argument);
    EXPECT_EQ(driver.read(0, 500, bytes, 29, now_ms), Status::bad_argument);
    EXPECT_EQ(driver.read(0, 0, bytes, 0, now_ms), Status::bad_argument);
    EXPECT_EQ(driver.read(0, 65535, bytes, 255, now_ms), Status::bad_argument);
    EXPECT_EQ(driver.fill(0, 527, bytes, 2, now_ms), Status::bad_argument);
    EXPECT_EQ(driver.fill(2, 0, bytes, 2, now_ms), Status::bad_argument);
    EXPECT_EQ(driver.store(2, 0, now_ms), Status::bad_argument);
    EXPECT_EQ(driver.store(0, 8192, now_ms), Status::bad_argument);
    EXPECT_EQ(driver.eraseBlock(8192, now_ms), Status::bad_argument);
    EXPECT_TRUE(transactions.empty());
    EXPECT_EQ(driver.read(8191, 500, bytes, 28, now_ms), Status::ok);
}

TEST_F(Scripted, answers_busy_until_the_chip_is_known) {
    driver.start(now_ms);

    EXPECT_EQ(driver.read(0, 0, bytes, 1, now_ms), Status::busy);
    EXPECT_EQ(driver.fill(0, 0, bytes, 1, now_ms), Status::busy);
    EXPECT_EQ(driver.store(0, 0, now_ms), Status::busy);
}

TEST_F(Scripted, says_unsupported_to_everything_without_a_chip) {
    identity = {0xFF, 0xFF};
    start();

    EXPECT_EQ(driver.read(0, 0, bytes, 1, now_ms), Status::unsupported);
    EXPECT_EQ(driver.fill(0, 0, bytes, 1, now_ms), Status::unsupported);
    EXPECT_EQ(driver.store(0, 0, now_ms), Status::unsupported);
    EXPECT_EQ(driver.eraseBlock(0, now_ms), Status::unsupported);
    EXPECT_FALSE(driver.busy(now_ms));
}

TEST_F(Scripted, does_not_ask_a_chip_that_has_nothing_to_do) {
    start();

    for (int i = 0; i < 100; ++i) driver.step(++now_ms);
    EXPECT_FALSE(driver.busy(now_ms));
    EXPECT_TRUE(transactions.empty());
}

TEST_F(Scripted, all_bytes_pass_while_selected) {
    start();
    EXPECT_EQ(driver.read(1, 0, bytes, 100, now_ms), Status::ok);
    EXPECT_EQ(driver.fill(0, 0, bytes, 100, now_ms), Status::ok);
    EXPECT_EQ(driver.store(0, 1, now_ms), Status::ok);

    EXPECT_EQ(FlashBus::clashes, 0);
    EXPECT_FALSE(FlashBus::selected);
}

TEST_F(OnModel, keeps_a_page_in_each_kind_of_chip) {
    for (const bool is_161d : {false, true}) {
        for (const bool pages_of_512 : {false, true}) {
            simulator::At45dbOptions options;
            options.is_161d = is_161d;
            options.pages_of_512 = pages_of_512;
            put(options);
            start();
            const uint16_t last = static_cast<uint16_t>(driver.pages() - 1);
            const uint16_t end = static_cast<uint16_t>(driver.pageSize() - 40);
            ASSERT_EQ(fill(0, end, pattern(40, 1)), Status::ok);
            ASSERT_EQ(store(0, last), Status::ok);
            wait_ms(18);

            ASSERT_EQ(read(last, end, 40), Status::ok);
            EXPECT_EQ(read_bytes, pattern(40, 1));
            EXPECT_EQ(chip->ignored(), 0u);
        }
    }
}

TEST_F(OnModel, answers_busy_while_it_programs_and_fills_the_other_buffer_meanwhile) {
    start();
    ASSERT_EQ(fill(0, 0, pattern(200, 1)), Status::ok);
    ASSERT_EQ(store(0, 5), Status::ok);

    EXPECT_TRUE(driver.busy(now_ms()));
    EXPECT_EQ(read(4, 0, 10), Status::busy);
    EXPECT_EQ(store(1, 6), Status::busy);
    EXPECT_EQ(driver.eraseBlock(8, now_ms()), Status::busy);
    EXPECT_EQ(fill(0, 0, {1}), Status::busy);
    EXPECT_EQ(fill(1, 0, pattern(200, 2)), Status::ok);
    wait_ms(17);

    EXPECT_FALSE(driver.busy(now_ms()));
    EXPECT_EQ(fill(0, 0, {1}), Status::ok);
    EXPECT_EQ(store(1, 6), Status::ok);
    wait_ms(17);
    ASSERT_EQ(read(6, 0, 200), Status::ok);
    EXPECT_EQ(read_bytes, pattern(200, 2));
    EXPECT_EQ(chip->ignored(), 0u);
}

TEST_F(OnModel, trusts_a_chip_that_takes_the_longest_it_may) {
    simulator::At45dbOptions options;
    options.slowest = true;
    put(options);
    start();
    for (int i = 0; i < 20; ++i) {
        now_us += 137;  // another place in its millisecond each time
        ASSERT_EQ(driver.eraseBlock(16, now_ms()), Status::ok);
        while (driver.busy(now_ms())) now_us += 50;
        ASSERT_EQ(driver.erasePage(16, now_ms()), Status::ok);
        while (driver.busy(now_ms())) now_us += 50;
        ASSERT_EQ(store(0, 16), Status::ok);
        while (driver.busy(now_ms())) now_us += 50;
        ASSERT_EQ(driver.trouble(), At45dbTrouble::none);
    }
}

TEST_F(OnModel, gives_up_a_chip_that_stays_busy) {
    start();
    chip->jam();
    ASSERT_EQ(store(0, 5), Status::ok);
    wait_ms(40);
    EXPECT_EQ(driver.trouble(), At45dbTrouble::none);
    wait_ms(2);

    EXPECT_EQ(driver.trouble(), At45dbTrouble::stuck);
    EXPECT_EQ(driver.pages(), 0);
    EXPECT_EQ(read(0, 0, 1), Status::unsupported);
    EXPECT_EQ(fill(1, 0, {1}), Status::unsupported);
    EXPECT_EQ(store(1, 1), Status::unsupported);
    EXPECT_FALSE(driver.busy(now_ms()));
}

TEST_F(OnModel, notices_that_the_chip_has_come_loose) {
    start();
    ASSERT_EQ(store(0, 5), Status::ok);
    chip->remove();
    wait_ms(10);

    EXPECT_EQ(driver.trouble(), At45dbTrouble::garbled);
    EXPECT_EQ(read(0, 0, 1), Status::unsupported);
}

TEST_F(OnModel, a_restart_of_the_processor_leaves_the_page_at_work_whole) {
    start();
    ASSERT_EQ(fill(0, 0, pattern(255, 7)), Status::ok);
    ASSERT_EQ(store(0, 5), Status::ok);
    now_us += 1000;
    driver = Driver();
    start();

    ASSERT_EQ(read(5, 0, 255), Status::ok);
    EXPECT_EQ(read_bytes, pattern(255, 7));
}

TEST_F(OnModel, comes_back_after_a_restart_from_every_trouble) {
    start();
    chip->jam();
    ASSERT_EQ(store(0, 5), Status::ok);
    wait_ms(60);
    ASSERT_EQ(driver.trouble(), At45dbTrouble::stuck);
    chip->cutPower(now_us);
    start();

    EXPECT_EQ(driver.trouble(), At45dbTrouble::none);
    EXPECT_EQ(read(0, 0, 1), Status::ok);
}
