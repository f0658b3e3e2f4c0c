// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/airplane/parameters.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <filesystem>
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
    EXPECT_THAT(complaint(replaced(trainerText(), "\"mass_kg\"",
                                   "\"elevons\": true, \"v_tail\": true, \"mass_kg\"")),
                HasSubstr("/elevons goes with neither /v_tail nor /flaperons"));
}

TEST(AirplaneText, is_read_back_as_it_was) {
    const std::string path =
        std::filesystem::temp_directory_path() / ("text_" + std::to_string(getpid()) + ".json");
    for (const char* name : {"foam_trainer", "trainer_6kg", "flying_wing"}) {
        AirplaneParameters airplane = loadAirplane(name);
        EXPECT_EQ(airplane.linkage.curve, 0) << "no file of ours has one";
        airplane.linkage = {0.01, -0.2};
        airplane.v_tail = airplane.flaperons = !airplane.elevons;
        airplane.flaps = {0.6, 0.04, -0.1};
        airplane.imu_place_m = {0.1, 0, -0.02};
        const std::string text = airplaneText(airplane, "for a test");
        std::ofstream(path) << text;
        EXPECT_EQ(airplaneText(loadAirplane(path), "for a test"), text) << name;
    }
    std::filesystem::remove(path);
}
