// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/airplane/parameters.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

using namespace simulator;
using testing::HasSubstr;

namespace {

std::string trainerText() {
    std::ifstream file(AIRPLANES "/foam_trainer.json");
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string complaint(const std::string& text) {
    const std::string path = testing::TempDir() + "airplane.json";
    std::ofstream(path) << text;
    try {
        loadAirplane(path);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

}  // namespace

TEST(Airplanes, are_found_by_name_and_by_path) {
    EXPECT_EQ(loadAirplane("foam_trainer").mass_kg, 1.2);
    EXPECT_EQ(loadAirplane(AIRPLANES "/foam_trainer.json").contacts.size(), 9u);
    EXPECT_EQ(complaint(trainerText()), "");
}

TEST(Airplanes, are_refused_with_the_reason_when_something_is_wrong) {
    EXPECT_THROW(loadAirplane("no_such_airplane"), std::runtime_error);
    EXPECT_THAT(complaint(replaced(trainerText(), "\"mass_kg\"", "\"mass_lb\"")),
                HasSubstr("lacks /mass_kg"));
    EXPECT_THAT(complaint(replaced(trainerText(), "\"mass_kg\"", "\"wheels\": 3, \"mass_kg\"")),
                HasSubstr("does not know /wheels"));
    EXPECT_THAT(complaint("{"), HasSubstr("parse error"));
}
