// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/drawn/draw.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "simulator/airplane/airplane.hpp"
#include "simulator/airplane/earth.hpp"
#include "simulator/drawn/estimate.hpp"
#include "simulator/drawn/files.hpp"
#include "simulator/ground/plan.hpp"
#include "simulator/world_file.hpp"

namespace {

using namespace simulator;
using drawn::DrawnWorld;

constexpr uint64_t kWorlds = 400;

DrawnWorld drawnBy(uint64_t seed) { return drawn::drawWorld(seed, MAGNETIC_MODEL); }

bool within(double value, double least, double most) { return value >= least && value <= most; }

double value(const ParameterSettings& settings, const std::string& name) {
    for (const auto& each : settings)
        if (each.name == name) return each.value;
    return NAN;
}

TEST(Draw, is_the_same_for_the_same_seed_and_another_for_another) {
    EXPECT_EQ(airplaneText(drawnBy(7).airplane, ""), airplaneText(drawnBy(7).airplane, ""));
    EXPECT_EQ(worldFileText(drawnBy(7).world), worldFileText(drawnBy(7).world));
    EXPECT_NE(airplaneText(drawnBy(7).airplane, ""), airplaneText(drawnBy(8).airplane, ""));
}

TEST(Draw, stays_within_what_owners_have) {
    for (uint64_t seed = 1; seed <= kWorlds; ++seed) {
        const DrawnWorld drawn = drawnBy(seed);
        const AirplaneParameters& p = drawn.airplane;
        const WorldOptions& w = drawn.world;
        EXPECT_TRUE(within(p.mass_kg, 0.5, 8)) << seed;
        EXPECT_TRUE(within(p.mass_kg / p.area_m2, 3, 9)) << seed;
        EXPECT_TRUE(within(1.5 / p.controls.rate_per_s, 0.1, 0.4)) << seed;
        EXPECT_LE(length(p.imu_place_m), 0.1) << seed;
        EXPECT_LT(p.pitch.alpha, 0) << seed << ": it is stable";
        EXPECT_GT(p.yaw.beta, 0) << seed;
        EXPECT_TRUE(within(w.errors->gps_age_s, 0.05, 0.4)) << seed;
        EXPECT_TRUE(within(w.board_warmth_c, -10, 25)) << seed;
        EXPECT_TRUE(within(w.board_warmth_start_c, -10, 25)) << seed;
        EXPECT_TRUE(within(w.wind_mps, 0, 10)) << seed;
        EXPECT_TRUE(within(w.errors->gust_mps, 0, 2)) << seed;
        EXPECT_TRUE(within(w.thermal_mps, 0, 2)) << seed;
        EXPECT_TRUE(within(w.altitude_m, 0, 3000)) << seed;
        EXPECT_TRUE(within(w.latitude_deg, -70, 70)) << seed;
        const double inclination = w.inclination_deg * M_PI / 180;
        EXPECT_GE(w.magnetic_field_mg * std::cos(inclination), 79.9) << seed;
    }
}

TEST(Draw, says_of_each_world_the_same_values_of_which_none_is_constant) {
    std::map<std::string, std::set<double>> found;
    for (uint64_t seed = 1; seed <= 20; ++seed)
        for (const auto& each : drawnBy(seed).values) {
            EXPECT_TRUE(std::isfinite(each.value)) << seed << ": " << each.key;
            found[each.key].insert(each.value);
        }
    EXPECT_EQ(found.size(), drawnBy(1).values.size());
    for (const auto& [key, values] : found) EXPECT_GT(values.size(), 1u) << key;
}

TEST(Draw, has_receivers_of_every_rate_and_airplanes_that_are_thrown) {
    std::set<double> rates_hz;
    unsigned thrown = 0;
    for (uint64_t seed = 1; seed <= kWorlds; ++seed) {
        const DrawnWorld drawn = drawnBy(seed);
        rates_hz.insert(drawn.world.errors->gps_rate_hz);
        thrown += drawn.airplane.launch.speed_mps > 0;
    }
    EXPECT_EQ(rates_hz, (std::set<double>{1, 5, 10}));
    EXPECT_TRUE(within(thrown, kWorlds / 4.0, kWorlds / 2.0)) << thrown;
}

TEST(Draw, sets_what_an_owner_knows_and_no_more) {
    const std::set<std::string> known = {"TRIM_ARSPD_CM", "ARSPD_FBW_MIN", "ARSPD_FBW_MAX",
                                         "BATT_CAPACITY", "TKOFF_THR_MINACC"};
    for (uint64_t seed = 1; seed <= kWorlds; ++seed) {
        const DrawnWorld drawn = drawnBy(seed);
        const double stall_mps = drawn::stallSpeed_mps(drawn.airplane);
        for (const auto& each : drawn.owner) EXPECT_EQ(known.count(each.name), 1u) << each.name;
        EXPECT_GE(value(drawn.owner, "ARSPD_FBW_MIN"), 1.2 * stall_mps) << seed;
        EXPECT_GT(value(drawn.owner, "TRIM_ARSPD_CM"), 140 * stall_mps) << seed;
        EXPECT_GT(value(drawn.owner, "ARSPD_FBW_MAX"), value(drawn.owner, "ARSPD_FBW_MIN"));
    }
}

TEST(Draw, climbs_out_of_the_sinking_air) {
    for (uint64_t seed = 1; seed <= kWorlds; ++seed) {
        const DrawnWorld drawn = drawnBy(seed);
        const double altitude_m = drawn.world.altitude_m + 150;
        const double density_kgm3 = atmosphere(altitude_m).density_kgm3;
        const double cruise_mps = value(drawn.owner, "TRIM_ARSPD_CM") / 100 *
                                  std::sqrt(kSeaLevelDensity_kgm3 / density_kgm3);
        const double climb_mps =
            cruise_mps * drawn::climbGradient(drawn.airplane, cruise_mps, density_kgm3);
        EXPECT_GT(climb_mps, drawn.world.thermal_mps) << seed;
    }
}

// Let go in level flight at its cruising speed and full throttle, it climbs about as steeply.
TEST(Draw, estimates_the_climb_that_is_flown) {
    for (uint64_t seed = 1; seed <= 10; ++seed) {
        DrawnWorld drawn = drawnBy(seed);
        WorldOptions calm;
        calm.altitude_m = 0;
        Airplane airplane(drawn.airplane, calm, 0);
        const double speed_mps = value(drawn.owner, "TRIM_ARSPD_CM") / 100;
        Motion motion;
        motion.position_m = {0, 0, -300};
        motion.velocity_mps = {speed_mps, 0, 0};
        airplane.place(motion, {0, 0, 0, 1});
        // energy height, so that it need not be held at one speed
        const auto energy_m = [&] {
            const Truth& t = airplane.truth();
            return t.height_m + t.airspeed_mps * t.airspeed_mps / (2 * kGravity_mss);
        };
        const double begun_m = energy_m();
        constexpr int kSteps = 200;
        for (int i = 0; i < kSteps; ++i) airplane.step({0, 0, 0, 1});
        const double flown = (energy_m() - begun_m) / (kSteps * Airplane::kStep_s * speed_mps);
        const double said = drawn::climbGradient(drawn.airplane, speed_mps, kSeaLevelDensity_kgm3);
        EXPECT_GT(flown, 0.9 * said) << seed;
        EXPECT_LT(flown, 1.4 * said + 0.05) << seed << ": on a full battery";
    }
}

TEST(Draw, lays_the_final_out_on_the_slope_of_the_field) {
    for (uint64_t seed = 1; seed <= 50; ++seed) {
        const DrawnWorld drawn = drawnBy(seed);
        const Waypoints& items = drawn.mission;
        const LocalFrame frame(items[0].latitude_deg, items[0].longitude_deg);
        const WaypointItem& above = items[items.size() - 2];
        const auto at = frame.at(above.latitude_deg, above.longitude_deg);
        const double slope = above.altitude_m / std::hypot(at.north_m, at.east_m);
        EXPECT_TRUE(within(slope, 0.0199, 0.0801)) << seed << ": " << slope;
        EXPECT_EQ(items.back().command, 21);
    }
}

TEST(DrawnFiles, are_what_was_drawn) {
    const auto folder =
        std::filesystem::temp_directory_path() / ("drawn_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    const DrawnWorld drawn = drawnBy(3);
    const drawn::DrawnFiles files(folder);
    writeFiles(files, drawn);

    EXPECT_EQ(airplaneText(loadAirplane(files.airplane), "x"), airplaneText(drawn.airplane, "x"));
    WorldOptions world;
    readWorldFile(files.world, world);
    EXPECT_EQ(worldFileText(world), worldFileText(drawn.world));
    const Waypoints read = readWaypoints(files.mission);
    ASSERT_EQ(read.size(), drawn.mission.size());
    for (size_t i = 0; i < read.size(); ++i) {
        EXPECT_EQ(read[i].command, drawn.mission[i].command);
        EXPECT_NEAR(read[i].latitude_deg, drawn.mission[i].latitude_deg, 1e-7);
        EXPECT_NEAR(read[i].altitude_m, drawn.mission[i].altitude_m, 0.01);
    }
    const auto json = nlohmann::json::parse(std::ifstream(files.drawn));
    EXPECT_EQ(json["format"], "apm-drawn");
    EXPECT_EQ(json["seed"], 3);
    EXPECT_EQ(json["about"], drawn.about);
    ASSERT_EQ(json["values"].size(), drawn.values.size());
    EXPECT_EQ(json["values"][0]["key"], "mass_kg");
    EXPECT_EQ(json["values"][0]["value"], drawn.airplane.mass_kg);
    std::filesystem::remove_all(folder);
}

}  // namespace
