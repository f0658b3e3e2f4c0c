// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

TEST(Stale, has_a_test) { EXPECT_TRUE(true); }
