// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/profile.hpp"

#include <gtest/gtest.h>

namespace simulator {
namespace {

using Step = Profile::Step;

TEST(Profile, gives_a_call_what_was_spent_in_it_without_its_interrupts) {
    Profile profile(0x400);

    profile.add(Step{0x100, 0x200, 4, 0x21FC, false, true});  // a call
    profile.add(Step{0x200, 0x004, 6, 0x21F9, true, false});  // 1 cycle, and an interrupt's entry
    profile.add(Step{0x004, 0x202, 30, 0x21FC, false, false});
    profile.add(Step{0x202, 0x104, 5, 0x21FF, false, false});  // its return
    profile.add(Step{0x104, 0x106, 1, 0x21FF, false, false});

    EXPECT_EQ(profile.json({"/a \"b\".elf", "01ab"}, 100),
              "{\"program\":{\"path\":\"/a \\\"b\\\".elf\",\"sha256\":\"01ab\"},\n\"all\":100,\n"
              "\"cycles\":[[4,35],\n[256,4],\n[260,1],\n[512,1],\n[514,5]],\n"
              "\"calls\":[[4,4,1,35],\n[256,512,1,6]]}\n");
}

}  // namespace
}  // namespace simulator
