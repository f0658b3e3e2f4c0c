// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

TEST(Stale, is_here) { EXPECT_TRUE(true); }
