// SPDX-License-Identifier: GPL-3.0-or-later
// In a program of tests of the firmware: each test begins as after power-on.
#include <gtest/gtest.h>

#include "fakes/fakes.hpp"

namespace {

class FreshStart : public testing::EmptyTestEventListener {
    void OnTestStart(const testing::TestInfo&) override { fakes::reset(); }
};

[[maybe_unused]] const bool kListens = [] {
    testing::UnitTest::GetInstance()->listeners().Append(new FreshStart);
    return true;
}();

}  // namespace
