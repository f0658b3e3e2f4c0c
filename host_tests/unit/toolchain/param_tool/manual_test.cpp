// SPDX-License-Identifier: GPL-3.0-or-later
// firmware/state/parameters.csv against the firmware's own table, and docs/parameters.md against
// both.
#include "rig.hpp"

namespace param_tool {
namespace {

std::vector<Parameter> defaults() {
    powerUp(mission_tool::blankImage(), "");
    return parameters();
}

TEST(ParameterManual, has_a_row_for_every_parameter_in_the_firmwares_order_and_no_other) {
    std::vector<std::string> of_firmware, of_manual;
    for (const Parameter& parameter : defaults()) of_firmware.push_back(parameter.name);
    for (const Explained& row : manual()) of_manual.push_back(row.name);
    EXPECT_EQ(of_manual, of_firmware);
}

TEST(ParameterManual, states_the_firmwares_defaults_and_ranges) {
    for (const Parameter& parameter : defaults()) {
        const Explained* const row = explanationOf(parameter.name);
        ASSERT_NE(row, nullptr) << parameter.name;
        EXPECT_EQ(std::stof(row->initial), parameter.initial) << parameter.name;
        EXPECT_EQ(std::stof(row->lowest), parameter.lowest) << parameter.name;
        EXPECT_EQ(std::stof(row->highest), parameter.highest) << parameter.name;
        EXPECT_EQ(parameter.value, parameter.initial) << parameter.name;
        EXPECT_GT(row->meaning.size(), 5u) << parameter.name;
    }
}

TEST(ParameterManual, is_what_the_page_shows) {
    EXPECT_EQ(mission_tool::readFile(PARAMETERS_MANUAL), document())
        << "toolchain/param document > docs/parameters.md";
}

TEST(ParameterManual, refuses_a_table_of_another_shape) {
    EXPECT_THROW(parseManual("", "x"), mission_tool::WrongInput);
    EXPECT_THROW(parseManual("name,unit\n", "x"), mission_tool::WrongInput);
    EXPECT_THROW(parseManual("name,unit,lowest,highest,default,meaning\nA,B,1,2\n", "x"),
                 mission_tool::WrongInput);
}

}  // namespace
}  // namespace param_tool
