// SPDX-License-Identifier: GPL-3.0-or-later
// The .param files beside the airplanes. That the firmware takes what they say is tried by
// toolchain/param in airplanes.param.*.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace {

namespace fs = std::filesystem;
constexpr int kMaxChanged = 5;  // besides the gains that AUTOTUNE finds

bool isSetting(const std::string& line) { return !line.empty() && line[0] != '#'; }
bool isTuned(const std::string& line) {
    const std::string name = line.substr(0, line.find(','));
    for (const char* axis : {"RLL2SRV_", "PTCH2SRV_"})
        for (const char* gain : {"TCONST", "P", "I", "D"})
            if (name == std::string(axis) + gain) return true;
    return false;
}

struct Settings {
    int tuned = 0, others = 0;
};
Settings settingsIn(const fs::path& path) {
    std::ifstream file(path);
    Settings settings;
    for (std::string line; std::getline(file, line);)
        if (isSetting(line)) ++(isTuned(line) ? settings.tuned : settings.others);
    return settings;
}

}  // namespace

TEST(ParameterFiles, stand_beside_every_airplane_and_change_little) {
    int airplanes = 0;
    for (const auto& entry : fs::directory_iterator(AIRPLANES)) {
        if (entry.path().extension() != ".json") continue;
        ++airplanes;
        const fs::path beside = fs::path(entry.path()).replace_extension(".param");
        ASSERT_TRUE(fs::exists(beside)) << beside;
        EXPECT_LE(settingsIn(beside).others, kMaxChanged) << beside;
    }
    EXPECT_GE(airplanes, 3);
}

TEST(ParameterFiles, leave_the_foam_trainer_on_the_firmwares_defaults) {
    const Settings foam_trainer = settingsIn(AIRPLANES "/foam_trainer.param");
    const Settings flying_wing = settingsIn(AIRPLANES "/flying_wing.param");
    EXPECT_EQ(foam_trainer.others, 0);
    EXPECT_EQ(foam_trainer.tuned, 0);
    EXPECT_GT(flying_wing.others, 0);
    EXPECT_GT(flying_wing.tuned, 0);
}
