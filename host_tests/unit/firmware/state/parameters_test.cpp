// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/state/parameters.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace {

TEST(ParameterTable, no_two_parameters_have_one_name) {
    std::set<std::string> names;
    for (uint16_t i = 0; i < firmware::state::parameterCount(); ++i) {
        char name[16] = {};
        float value = 0;
        uint8_t type = 0;
        ASSERT_TRUE(firmware::state::parameterAt(i, name, value, type));
        const std::string text(name, strnlen(name, sizeof name));
        EXPECT_TRUE(names.insert(text).second) << text << " is the name of two rows";
    }
    EXPECT_GT(names.size(), 100u);
}

}  // namespace
