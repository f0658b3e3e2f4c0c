// SPDX-License-Identifier: GPL-3.0-or-later
#include "host_tests/unit/simulator/invariants/flown.hpp"

namespace simulator::invariants {

using mavlink::MavCmd;

TEST(NoRestartByItself, a_restart_that_nobody_provoked_violates_it) {
    Flown made, by_itself, asked;
    for (Flown* flown : {&made, &by_itself, &asked}) flown->run(5);
    made.watch.provokedRestart(false);
    asked.command(MavCmd::preflight_reboot_shutdown, 1);
    for (Flown* flown : {&made, &by_itself, &asked}) {
        flown->restart();
        flown->run(1);
    }
    EXPECT_EQ(made.violated(), "");
    EXPECT_EQ(by_itself.violated(), "restart_by_itself ");
    EXPECT_EQ(asked.violated(), "");
}

TEST(FrameInTime, a_late_frame_and_a_stack_too_deep_violate_it) {
    Flown well, late, deep;
    well.figures.frame_overruns = 0;
    late.figures.frame_overruns = 1;
    well.figures.ram_static_bytes = deep.figures.ram_static_bytes = 7000;
    well.figures.stack_max_bytes = 1192;
    deep.figures.stack_max_bytes = 1193;
    EXPECT_EQ(well.violated(), "");
    EXPECT_EQ(late.violated(), "late_frame ");
    EXPECT_EQ(deep.violated(), "late_frame ");
}

}  // namespace simulator::invariants
