// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/world_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace {

using namespace simulator;

class WorldFile : public ::testing::Test {
protected:
    const std::string path =
        std::filesystem::temp_directory_path() / ("world_" + std::to_string(getpid()) + ".json");
    WorldOptions world;

    ~WorldFile() override { std::filesystem::remove(path); }
    void read(const std::string& text) {
        std::ofstream(path) << text;
        readWorldFile(path, world);
    }
    std::string complaint(const std::string& text) {
        try {
            read(text);
        } catch (const WorldFileError& error) {
            return error.what();
        }
        return "";
    }
};

TEST_F(WorldFile, changes_what_it_names_and_leaves_the_rest) {
    read(R"({"about": "windy", "wind_mps": 7, "errors": {"gps_rate_hz": 1, "gust_mps": 1.5}})");
    EXPECT_EQ(world.wind_mps, 7);
    EXPECT_EQ(world.errors->gps_rate_hz, 1);
    EXPECT_EQ(world.errors->gyro_bias_dps, SensorErrors{}.gyro_bias_dps);
    EXPECT_TRUE(world.gusts);
    EXPECT_EQ(world.declination_deg, WorldOptions{}.declination_deg);
}

TEST_F(WorldFile, is_read_as_it_was_written) {
    world.motor_field_mg_a = {1, -2, 0.5};
    world.thermal_mps = 1.25;
    world.errors = SensorErrors{};
    world.errors->gps_age_s = 0.35;
    const std::string text = worldFileText(world);
    world = {};
    read(text);
    EXPECT_EQ(worldFileText(world), text);
    EXPECT_EQ(world.gps_latency_s, 0.35);
}

TEST_F(WorldFile, complains_in_one_line_that_names_the_file) {
    const std::pair<const char*, const char*> wrong[] = {
        {R"({"wind": 5})", "does not know 'wind'"},
        {R"({"errors": {"gps": 5}})", "does not know 'errors/gps'"},
        {R"({"wind_mps": "5"})", "'wind_mps': expected a number"},
        {R"({"wind_mps": 31})", "'wind_mps': expected 0"},
        {R"({"errors": {"gps_rate_hz": -1}})", "'gps_rate_hz': expected 0"},
        {R"({"motor_field_mg_a": [1, 2]})", "expected three numbers"},
        {"[]", "expected a JSON object"},
        {"{", "expected JSON, found an error in line 1"},
        {"{\n\"wind_mps\": 5,\n", "expected JSON, found an error in line 3"},
        {"", "expected JSON, found nothing"},
        {R"({"wind_mps": NaN})", "expected JSON, found an error in line 1"},
    };
    for (const auto& [text, expected] : wrong) {
        const std::string said = complaint(text);
        EXPECT_EQ(said.rfind(path + ": ", 0), 0u) << said;
        EXPECT_NE(said.find(expected), said.npos) << said;
        EXPECT_EQ(said.find('\n'), said.npos) << said;
    }
}

TEST_F(WorldFile, that_is_absent_is_an_error) {
    EXPECT_THROW(readWorldFile(path + ".none", world), WorldFileError);
}

}  // namespace
