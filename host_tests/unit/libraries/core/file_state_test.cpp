// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file_state.hpp"

#include <gtest/gtest.h>

namespace {

struct Count {
    int passed = 3;
    int left[2];
};
core::FileState<Count> count{};

class Bound {
public:
    explicit Bound(const int& limit) : limit_(limit) {}
    void raise() { ++extra_; }
    int highest() const { return limit_ + extra_; }

private:
    const int& limit_;
    int extra_ = 0;
};
const int kLimit = 10;
core::FileState<Bound> bound(Bound{kLimit});

TEST(FileState, begins_with_the_values_of_its_struct_and_zeros) {
    EXPECT_EQ(count.passed, 3);
    EXPECT_EQ(count.left[0], 0);
    EXPECT_EQ(count.left[1], 0);
    EXPECT_EQ(bound.highest(), 10);
}

TEST(FileState, has_the_address_of_its_struct) {
    EXPECT_EQ(static_cast<void*>(&count), static_cast<Count*>(&count));
}

TEST(FileState, takes_a_value_of_its_struct) {
    count = {5, {6, 7}};
    EXPECT_EQ(count.passed, 5);
    EXPECT_EQ(count.left[1], 7);
    count = {};
    EXPECT_EQ(count.passed, 3);
}

TEST(FileState, each_is_reset_by_one_call) {
    count = {5, {6, 7}};
    bound.raise();
    core::resetFileStates();
    EXPECT_EQ(count.passed, 3);
    EXPECT_EQ(count.left[0], 0);
    EXPECT_EQ(bound.highest(), 10);
}

}  // namespace
