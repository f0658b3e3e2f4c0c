// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <fstream>

#include "machine/machine.hpp"

using simulator::Chip;
using simulator::Image;
using simulator::readImage;
using testing::HasSubstr;

namespace {

std::string refusal(const std::string& path) {
    try {
        readImage(path);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

std::string fileOf(const std::string& name, const std::string& text) {
    const std::string path = testing::TempDir() + name;
    std::ofstream(path) << text;
    return path;
}

}  // namespace

TEST(Image, an_elf_tells_flash_and_static_ram) {
    const Image image = readImage(program("stack.elf"));

    EXPECT_EQ(image.flash.size(), image.flash_bytes);
    EXPECT_GT(image.flash_bytes, 200u);
    EXPECT_EQ(image.ram_static_bytes, 4u + 10 + 6 + 1);  // see stack.cpp
}

TEST(Image, a_hex_holds_the_same_flash_and_no_ram_figure) {
    const Image elf = readImage(program("stack.elf")), hex = readImage(program("stack.hex"));

    EXPECT_EQ(hex.flash, elf.flash);
    EXPECT_EQ(hex.flash_bytes, elf.flash_bytes);
    EXPECT_FALSE(hex.ram_static_bytes);
}

TEST(Image, refuses_what_is_no_firmware_in_one_line) {
    EXPECT_THAT(refusal("/nowhere/x.elf"), HasSubstr("cannot be opened"));
    EXPECT_THAT(refusal("/proc/self/exe"), HasSubstr("not for an AVR"));
    EXPECT_THAT(refusal(fileOf("text.hex", "hello\n")), HasSubstr("neither an ELF nor"));
    EXPECT_THAT(refusal(fileOf("sum.hex", ":0100000042BE\n:00000001FF\n")), HasSubstr("line 1"));
    EXPECT_THAT(refusal(fileOf("cut.hex", ":0100000042BD\n")), HasSubstr("cut short"));
    EXPECT_THAT(refusal(fileOf("big.hex",
                               ":020000020000FC\n:020000040004F6\n:0100000042BD\n"
                               ":00000001FF\n")),
                HasSubstr("larger than"));
}

TEST(Image, refuses_an_elf_for_another_avr) {
    std::ifstream original(program("stack.elf"), std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(original), {}};
    constexpr size_t kFlags = 0x24;  // e_flags: 5 is the ATmega328P's family
    bytes[kFlags] = static_cast<char>((bytes[kFlags] & ~0x7F) | 5);
    EXPECT_THAT(refusal(fileOf("other.elf", bytes)), HasSubstr("another AVR"));
    EXPECT_THAT(refusal(fileOf("cut.elf", bytes.substr(0, 20))), HasSubstr("not a whole ELF"));
}

TEST(Chip, stops_at_the_cycle_asked_for) {
    Machine machine("stack");
    for (uint64_t until : {1000u, 1001u, 123456u}) {
        ASSERT_TRUE(machine.chip.run(until));
        EXPECT_GE(machine.chip.cycle(), until);
        EXPECT_LE(machine.chip.cycle(), until + 12);
    }
}

TEST(Chip, two_chips_run_alike) {
    Machine one("interrupts"), other("interrupts");
    one.run_ms(3);
    for (int i = 0; i < 30; i++) other.run_ms(0.1);

    ASSERT_EQ(one.reports.size(), other.reports.size());
    for (size_t i = 0; i < one.reports.size(); i++)
        EXPECT_EQ(one.reports[i].cycle, other.reports[i].cycle);
}

TEST(Chip, says_why_it_can_not_go_on) {
    const std::string halt = fileOf("halt.hex", ":020000008895E1\n:00000001FF\n");  // sleep
    Chip chip(readImage(halt));

    EXPECT_FALSE(chip.run(1000));
    EXPECT_THAT(chip.fault(), HasSubstr("sleeps with interrupts off"));
    EXPECT_FALSE(chip.run(2000));
}

TEST(Chip, counts_the_deepest_stack_exactly) {
    Machine machine("stack");
    machine.run_ms(1);

    // The program reports its stack pointer at its deepest, in a leaf whose frame no call shows.
    EXPECT_EQ(machine.chip.stack().maxBytes(), 0x21FFu - machine.report(1).word());
}

TEST(Chip, sleep_is_counted) {
    Machine machine("stack");
    machine.run_ms(100);

    EXPECT_GT(machine.chip.asleepCycles(), 16000u * 95);
    EXPECT_LT(machine.chip.asleepCycles(), 16000u * 100);
}
