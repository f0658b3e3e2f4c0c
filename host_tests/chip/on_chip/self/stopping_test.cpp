// SPDX-License-Identifier: GPL-3.0-or-later
// A test that never ends, as after a wild jump.
#include <gtest/gtest.h>
#include <stdlib.h>

TEST(Stopping, stops_in_the_middle_of_a_test) { abort(); }
