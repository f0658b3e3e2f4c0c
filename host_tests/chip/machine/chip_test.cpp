// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <malloc.h>

#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <sstream>

#include "machine.hpp"

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

std::string bytesOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

// stack.elf with this number at this place.
template <class Number>
std::string withNumber(size_t at, Number number) {
    std::string bytes = bytesOf(program("stack.elf"));
    bytes.replace(at, sizeof number, reinterpret_cast<const char*>(&number), sizeof number);
    return fileOf("damaged.elf", bytes);
}

// A program of these bytes, in Intel's format.
std::string hexProgram(const std::string& name, const std::vector<uint8_t>& code) {
    std::ostringstream text;
    uint8_t sum = 0;
    const auto put = [&](unsigned byte) {
        text << std::hex << std::uppercase << std::setw(2) << std::setfill('0') << byte;
        sum = static_cast<uint8_t>(sum + byte);
    };
    text << ':';
    for (const unsigned byte : {static_cast<unsigned>(code.size()), 0u, 0u, 0u}) put(byte);
    for (const uint8_t byte : code) put(byte);
    put(static_cast<uint8_t>(-sum));
    return fileOf(name, text.str() + "\n:00000001FF\n");
}

}  // namespace

TEST(Image, an_elf_gives_flash_and_static_ram_sizes) {
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

// The places are those of ELF32: header 52 bytes, the segments behind it, 32 bytes each.
TEST(Image, refuses_an_elf_whose_parts_lie_outside_the_file_or_the_chip) {
    constexpr size_t kClass = 4, kType = 16, kSegments = 28, kSections = 32, kSegmentSize = 42;
    constexpr size_t kFirst = 52, kOffset = 4, kUsedAt = 8, kStoredAt = 12, kStored = 16,
                     kUsed = 20;
    constexpr size_t kSecond = kFirst + 32;
    EXPECT_THAT(refusal(withNumber<uint8_t>(kClass, 2)), HasSubstr("32 bits"));
    EXPECT_THAT(refusal(withNumber<uint8_t>(kClass + 1, 2)), HasSubstr("least byte first"));
    EXPECT_THAT(refusal(withNumber<uint16_t>(kType, 1)), HasSubstr("no linked program"));
    EXPECT_THAT(refusal(withNumber<uint32_t>(kSegments, 0xFFFFFFF0)), HasSubstr("cut short"));
    EXPECT_THAT(refusal(withNumber<uint32_t>(kSections, 0xFFFFFFF0)), HasSubstr("cut short"));
    EXPECT_THAT(refusal(withNumber<uint16_t>(kSegmentSize, 7)), HasSubstr("damaged"));
    EXPECT_THAT(refusal(withNumber<uint32_t>(kFirst + kOffset, 0xFFFFFFF0)),
                HasSubstr("cut short"));
    EXPECT_THAT(refusal(withNumber<uint32_t>(kFirst + kStored, 0x50000)), HasSubstr("256 KiB"));
    EXPECT_THAT(refusal(withNumber<uint32_t>(kFirst + kStoredAt, 0x3FFFF)), HasSubstr("256 KiB"));
    EXPECT_THAT(refusal(withNumber<uint32_t>(kSecond + kUsedAt, 0x8021FE)), HasSubstr("fits no"));
    EXPECT_THAT(refusal(withNumber<uint32_t>(kSecond + kUsed, 0xFFFFFFFF)), HasSubstr("fits no"));
    EXPECT_THAT(refusal(withNumber<uint32_t>(kSecond + kUsed, 0)), HasSubstr("damaged"));
    EXPECT_THAT(refusal(withNumber<uint32_t>(kSecond + kStoredAt, 0x800100)), HasSubstr("RAM"));
}

TEST(Image, takes_an_elf_with_debug_sections) {
    const std::string plain = program("stack.elf"), debug = testing::TempDir() + "debug.elf";
    const std::string more = fileOf("debug.bytes", std::string(300'000, 'd'));
    ASSERT_EQ(std::system(("avr-objcopy --add-section .debug_str_offsets=" + more + " " + plain +
                           " " + debug)
                              .c_str()),
              0);
    EXPECT_GT(bytesOf(debug).size(), bytesOf(plain).size());
    EXPECT_EQ(readImage(debug).flash, readImage(plain).flash);
    EXPECT_EQ(readImage(debug).ram_static_bytes, readImage(plain).ram_static_bytes);
}

TEST(Image, of_random_damage_is_read_or_refused) {
    const std::string good = bytesOf(program("stack.elf"));
    uint32_t random = 12345;
    const auto below = [&random](size_t limit) {
        random = random * 1664525 + 1013904223;
        return (random >> 8) % limit;
    };
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        std::string bytes = good;
        for (size_t changes = 1 + below(4); changes > 0; --changes)
            bytes[below(52 + 4 * 32)] = static_cast<char>(below(256));
        if (below(4) == 0) bytes.resize(below(bytes.size()));
        refused += !refusal(fileOf("random.elf", bytes)).empty();
    }
    EXPECT_GT(refused, 1000);
    EXPECT_LT(refused, 3000);
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

// libsimavr makes a write behind the RAM although it says that the program has crashed by it: the
// byte must be one of the chip's own, for every address of 16 bits.
TEST(Chip, a_program_that_writes_behind_the_ram_ends_with_its_reason) {
    const std::string astray =
        hexProgram("astray.hex", {0xA8, 0xE0, 0xB2, 0xE2, 0x0F, 0xEF, 0x0C, 0x93, 0xFF, 0xCF});
    Chip chip(readImage(astray));  // ldi r26,8; ldi r27,0x22; ldi r16,0xff; st X,r16

    EXPECT_FALSE(chip.run(1000));
    EXPECT_THAT(chip.fault(), HasSubstr("the CPU has crashed"));
    EXPECT_GE(malloc_usable_size(chip.avr()->data), 0x10000u);
    EXPECT_EQ(chip.avr()->data[0x2208], 0xFF);
}

TEST(Chip, has_two_bits_of_rampz) {
    Chip chip(readImage(hexProgram("rampz.hex", {0x0F, 0xEF, 0x0B, 0xBF, 0xFF, 0xCF})));
    ASSERT_TRUE(chip.run(100));  // ldi r16,0xff; out RAMPZ,r16
    EXPECT_EQ(chip.avr()->data[simulator::kRampz], 3);
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
