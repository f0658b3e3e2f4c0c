// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/vcd_trace.hpp"

#include <gmock/gmock.h>

#include "simulator/output_file.hpp"

using simulator::OutputError;
using simulator::VcdTrace;
using testing::HasSubstr;

TEST(VcdTrace, refuses_a_place_where_nothing_can_be_written_at_once) {
    EXPECT_THROW(VcdTrace("/no/such/x.vcd", {{"a", 1}}), OutputError);
    EXPECT_THROW(VcdTrace(testing::TempDir(), {{"a", 1}}), OutputError);
    EXPECT_THROW(VcdTrace("/dev/full", {{"a", 1}}), OutputError);
}

TEST(VcdTrace, says_at_its_end_that_it_is_whole) {
    VcdTrace trace(testing::TempDir() + "whole.vcd", {{"a", 1}});
    for (uint64_t cycle = 0; cycle < 100'000; ++cycle) trace.change(0, cycle & 1, cycle);
    EXPECT_NO_THROW(trace.close());
    EXPECT_THROW(trace.close(), OutputError);  // nothing can be added any more
}
