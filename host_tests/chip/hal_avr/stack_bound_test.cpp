// SPDX-License-Identifier: GPL-3.0-or-later
// The computed bound against the deepest stack that a run of the same program showed.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

#include "bench.hpp"

namespace {

uint32_t boundOf(const std::string& name) {
    const std::string command = std::string(STACK_BOUND) + ' ' + program("hal_" + name + ".elf");
    FILE* tool = popen(command.c_str(), "r");
    char line[1000] = "";
    if (fgets(line, sizeof line, tool) == nullptr) line[0] = 0;
    EXPECT_EQ(pclose(tool), 0) << command;
    unsigned bytes = 0;
    EXPECT_EQ(sscanf(line, "stack %u", &bytes), 1) << line;
    return bytes;
}

}  // namespace

TEST(StackBound, is_never_below_what_a_program_used_nor_far_above) {
    for (const char* name : {"clock", "serial", "pwm", "ppm", "twi", "eeprom", "adc"}) {
        Bench bench(name);
        bench.run_ms(300);

        const uint32_t used = bench.chip.stack().maxBytes();
        EXPECT_GE(boundOf(name), used) << name;
        EXPECT_LE(boundOf(name), used + 60) << name;
    }
}
