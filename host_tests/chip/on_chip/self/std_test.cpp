// SPDX-License-Identifier: GPL-3.0-or-later
// The little of the standard library that the tests have on the chip, where it could be wrong
// without a test of a library noticing.
#include <gtest/gtest.h>

#include <deque>
#include <functional>
#include <random>
#include <set>

namespace {

TEST(Twister, its_ten_thousandth_number_is_the_standards) {
    std::mt19937 random;
    for (int i = 1; i < 10000; ++i) random();
    EXPECT_EQ(random(), 4123659995u);
}

TEST(Normal, has_the_mean_and_spread_it_promises) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    double sum = 0, square = 0;
    for (int i = 0; i < 2000; ++i) {
        const double x = normal(random);
        sum += x;
        square += x * x;
    }
    EXPECT_NEAR(sum / 2000, 0, 0.07);
    EXPECT_NEAR(square / 2000, 1, 0.1);
}

TEST(Vector, keeps_its_order_through_insertions_and_erasures) {
    std::vector<std::string> all = {"b", "d"};
    all.insert(all.begin(), "a");
    all.insert(all.begin() + 2, "c");
    all.push_back(all[0]);
    EXPECT_EQ(all, (std::vector<std::string>{"a", "b", "c", "d", "a"}));
    all.erase(all.begin() + 1);
    EXPECT_EQ(all, (std::vector<std::string>{"a", "c", "d", "a"}));
}

TEST(Deque, is_first_in_first_out) {
    std::deque<int> row;
    for (int i = 0; i < 10; ++i) row.push_back(i);
    row.pop_front();
    EXPECT_EQ(row.front(), 1);
    EXPECT_EQ(row.size(), 9u);
}

TEST(String, is_searched_and_cut) {
    const std::string text = "W1! +1 W" + std::to_string(-12);
    EXPECT_EQ(text, "W1! +1 W-12");
    EXPECT_EQ(text.find("+1"), 4u);
    EXPECT_EQ(text.find("-2"), std::string::npos);
    EXPECT_EQ(text.substr(4, 2), "+1");
}

TEST(Function, copies_what_it_holds) {
    int calls = 0;
    std::function<int(int)> one = [&](int x) {
        ++calls;
        return x + 1;
    };
    const std::function<int(int)> other = one;
    one = nullptr;
    EXPECT_FALSE(one);
    EXPECT_EQ(other(2), 3);
    EXPECT_EQ(calls, 1);
}

}  // namespace
