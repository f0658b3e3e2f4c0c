// SPDX-License-Identifier: GPL-3.0-or-later
// Each limit of `mission check` from both sides: what is just within it is not named, and what is
// just beyond it is.
#include <cmath>

#include "firmware/state/parameters.hpp"
#include "flight_conditions.hpp"

namespace mission_tool {
namespace {

using firmware::state::parameters;
using testing::HasSubstr;
using testing::Not;

int32_t north_e7(double metres) { return 470000000 + static_cast<int32_t>(metres / 111'180 * 1e7); }

// WAYPOINT, or what `id` is, north of home.
std::string northOfHome(double metres, double height_m = 60, const char* id = "0x10", int p1 = 0) {
    return std::string(id) + " 1 " + std::to_string(p1) + ' ' +
           std::to_string(std::lround(height_m * 100)) + ' ' + std::to_string(north_e7(metres)) +
           " 80000000\n";
}
std::string circle(double metres) { return northOfHome(metres, 60, "0x12", 1); }

Conditions upTo(double north_m) { return within(-500, north_m, -500, 500); }

constexpr char kLeg[] = "2: the leg leaves the fence by ",
               kNear[] = "2: warning: the leg comes within ";
constexpr char kCircle[] = "2: the circle of 60 m leaves the fence by ",
               kNearCircle[] = "2: warning: the circle of 60 m comes within ";

TEST(FlightLimits, a_leg_and_the_fence) {
    const std::string mission = good(northOfHome(600));
    EXPECT_EQ(found(mission, upTo(621)), "");
    EXPECT_THAT(found(mission, upTo(619)), HasSubstr(std::string(kNear) + "19 m of the fence"));
    EXPECT_THAT(found(mission, upTo(601)), HasSubstr(kNear));
    EXPECT_THAT(found(mission, upTo(601)), Not(HasSubstr("leaves")));
    EXPECT_THAT(found(mission, upTo(599)), HasSubstr(std::string(kLeg) + "1 m"));
}

TEST(FlightLimits, a_circle_and_the_fence) {
    const std::string mission = good(circle(600));
    EXPECT_EQ(found(mission, upTo(681)), "");
    EXPECT_THAT(found(mission, upTo(679)), HasSubstr(kNearCircle));
    EXPECT_THAT(found(mission, upTo(661)), Not(HasSubstr("leaves")));
    EXPECT_THAT(found(mission, upTo(659)), HasSubstr(std::string(kCircle) + "1 m"));
}

// A notch of the rim that no corner of the mission is near.
TEST(FlightLimits, the_middle_of_a_leg_and_the_fence) {
    const auto notched = [](double to_m) {
        Conditions conditions = upTo(700);
        auto& rim = conditions.fence.areas[0].rim;
        rim.insert(rim.begin() + 2, {at(200, 500), at(300, to_m), at(400, 500)});
        return conditions;
    };
    const std::string mission = good(northOfHome(600));
    EXPECT_EQ(found(mission, notched(21)), "");
    EXPECT_THAT(found(mission, notched(19)), HasSubstr(kNear));
    EXPECT_THAT(found(mission, notched(-5)), HasSubstr(kLeg));
}

TEST(FlightLimits, home_and_the_fence) {
    EXPECT_THAT(found(good(), within(-1, 800, -200, 900)), Not(HasSubstr("home lies")));
    EXPECT_THAT(found(good(), within(1, 800, -200, 900)), HasSubstr("0: home lies 1 m outside"));
}

TEST(FlightLimits, heights_and_the_fence) {
    const auto between = [](int16_t lowest_m, int16_t highest_m) {
        return found(good(northOfHome(600)), {}, [=] {
            parameters.fence_min_m = lowest_m;
            parameters.fence_max_m = highest_m;
            parameters.rtl_height_cm = 6000;
        });
    };
    EXPECT_EQ(between(60, 61), "");
    EXPECT_EQ(between(50, 60), "");
    EXPECT_THAT(between(50, 59), HasSubstr("2: flies at 60 m above home, over FENCE_MAXALT, 59 m"));
    EXPECT_THAT(between(50, 59), HasSubstr("0: RTL flies at 60 m (ALT_HOLD_RTL), over"));
    EXPECT_THAT(between(61, 70),
                HasSubstr("2: flies at 60 m above home, under FENCE_MINALT, 61 m"));
}

TEST(FlightLimits, the_height_of_rtl) {
    const auto at_height = [](int32_t height_cm) {
        return found(good(), {}, [=] { parameters.rtl_height_cm = height_cm; });
    };
    EXPECT_EQ(at_height(6000), "");
    EXPECT_THAT(at_height(5999), HasSubstr("0: warning: RTL flies at 60 m (ALT_HOLD_RTL), lower"));
}

// 60 m: 45 degrees at 24.26 m/s, 13 of them through the air.
TEST(FlightLimits, the_bank_of_a_circle_in_wind) {
    EXPECT_EQ(found(good(circle(600)), inWind(11.2)), "");
    EXPECT_THAT(found(good(circle(600)), inWind(11.3)),
                HasSubstr("2: warning: the circle of 60 m needs 45 degrees of bank at 24.3 m/s"));
}

// It follows the cruising speed: 45 degrees at 24.26 m/s.
TEST(FlightLimits, the_bank_of_a_circle_at_cruise) {
    const auto at_speed = [](int32_t speed_cms) {
        return found(good(circle(600)), inWind(6), [=] {
            parameters.cruise_speed_cms = speed_cms;
            parameters.stall_prevention = 0;
        });
    };
    EXPECT_THAT(at_speed(1820), Not(HasSubstr("of bank at")));
    EXPECT_THAT(at_speed(1830), HasSubstr("degrees of bank at 24.3 m/s"));
}

TEST(FlightLimits, the_wind_against_a_leg) {
    EXPECT_THAT(found(good(), inWind(12.9)), Not(HasSubstr("is not reached")));
    EXPECT_THAT(found(good(), inWind(13)), HasSubstr("1: is not reached: the wind of 13.0 m/s"));
}

TEST(FlightLimits, the_gradient_of_a_climb) {
    EXPECT_THAT(found(good(northOfHome(556, 183))), Not(HasSubstr("needs a climb")));
    EXPECT_THAT(found(good(northOfHome(556, 184))), HasSubstr("2: warning: needs a climb of 4.1"));
}

TEST(FlightLimits, the_gradient_of_a_sink) {
    const auto down = [](double height_m) {
        return found(good(northOfHome(3000, 300) + northOfHome(2500, height_m)));
    };
    EXPECT_THAT(down(185), Not(HasSubstr("3: warning: needs a sink")));
    EXPECT_THAT(down(183), HasSubstr("3: warning: needs a sink"));
}

TEST(FlightLimits, the_distance_from_home) {
    EXPECT_THAT(found(good(northOfHome(4999))), Not(HasSubstr("from home")));
    EXPECT_THAT(found(good(northOfHome(5001))),
                HasSubstr("2: warning: 5001 m from home, farther than 5000 m (--range)"));
    EXPECT_THAT(found(good(circle(4939))), Not(HasSubstr("from home")));
    EXPECT_THAT(found(good(circle(4941))), HasSubstr("2: warning: 5001 m from home"));
}

TEST(FlightLimits, takeoff_and_landing) {
    EXPECT_EQ(found(kHome + std::string(kTakeoff) + kNorth + kLand), "");
    EXPECT_EQ(found(kHome + std::string(kNorth) + kLand),
              "1: warning: no TAKEOFF before it: the flight begins with WAYPOINT\n");
    EXPECT_EQ(found(kHome + std::string(kTakeoff) + kNorth),
              "2: warning: no LAND: the mission ends in RTL\n");
}

}  // namespace
}  // namespace mission_tool
