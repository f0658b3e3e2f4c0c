// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/order.hpp"

#include <gmock/gmock.h>

using namespace simulator::live;
using namespace simulator;
using testing::Contains;
using testing::Not;
using Do = Order::Do;

namespace {

std::string why(const std::string& json) {
    try {
        readOrder(json);
    } catch (const OrderError& error) {
        return error.what();
    }
    return "taken";
}

}  // namespace

TEST(Order, is_read_from_json) {
    EXPECT_EQ(readOrder(R"({"do":"arm"})").what, Do::arm);
    EXPECT_EQ(readOrder(R"({"do":"takeoff","more":1})").what, Do::takeoff);
    EXPECT_EQ(readOrder(R"({"do":"mode","mode":"AUTO"})").mode, 10u);
    EXPECT_EQ(readOrder(R"({"do":"speed","times":5})").times, 5);
    EXPECT_EQ(readOrder(R"({"do":"speed","times":"max"})").times, 0);
    const Order place = readOrder(R"({"do":"goto","lat_deg":47.5,"lon_deg":-8,"altitude_m":60})");
    EXPECT_EQ(place.what, Do::go_to);
    EXPECT_EQ(place.latitude_deg, 47.5);
    EXPECT_EQ(place.longitude_deg, -8);
    EXPECT_EQ(place.height_m, 60);
    EXPECT_FALSE(readOrder(R"({"do":"goto","lat_deg":1,"lon_deg":2})").height_m);
    const Order wind = readOrder(R"({"do":"wind","speed_mps":6.5,"from_deg":270})");
    EXPECT_EQ(wind.wind_mps, 6.5);
    EXPECT_EQ(wind.wind_from_deg, 270);
    const Order sticks = readOrder(R"({"do":"sticks","roll":-1,"pitch":0.5,"throttle":1,"yaw":0})");
    EXPECT_EQ(sticks.roll, -1);
    EXPECT_EQ(sticks.throttle, 1);
}

TEST(Order, names_faults_as_the_command_line_does) {
    const Order lost = readOrder(R"({"do":"fault","name":"gps_lost","on":true})");
    EXPECT_EQ(lost.fault.sensor, Faulty::gps);
    EXPECT_EQ(lost.fault.kind, FaultKind::lost);
    EXPECT_EQ(lost.fault_name, "gps:lost");
    EXPECT_FALSE(readOrder(R"({"do":"fault","name":"imu:dead_roll","on":false})").on);
    EXPECT_EQ(faultNamed("supply_sag_3.2v")->volts, 3.2);
    EXPECT_EQ(faultNamed("radio:throttle_lost")->kind, FaultKind::throttle_lost);
    for (const char* none :
         {"", "gps", "gps_", "gps:drift", "gps:lost@3", "lost_gps", "gps:lost@0-9"})
        EXPECT_FALSE(faultNamed(none)) << none;
}

TEST(Order, offers_what_it_takes) {
    for (const std::string& name : faultNames()) EXPECT_TRUE(faultNamed(name)) << name;
    for (const std::string& name : modeNames())
        EXPECT_EQ(why("{\"do\":\"mode\",\"mode\":\"" + name + "\"}"), "taken");
    EXPECT_THAT(faultNames(), Contains("gps:lost"));
    EXPECT_THAT(faultNames(), Not(Contains("gps:drift")));
}

TEST(Order, refuses_nonsense_with_its_reason) {
    for (const char* json : {"", "null", "[]", "7", "{", "\"arm\"", "\xFF\xFE", "arm"})
        EXPECT_EQ(why(json), "expected a JSON object") << json;
    EXPECT_EQ(why(std::string(10'000, '[')), "expected one flat JSON object");
    EXPECT_EQ(why("{}"), "do: expected a word");
    EXPECT_EQ(why(R"({"do":7})"), "do: expected a word");
    EXPECT_THAT(why(R"({"do":"fly"})"), testing::StartsWith("do: expected arm, disarm"));
    EXPECT_EQ(why(R"({"do":"mode","mode":"WARP"})"), "mode: there is no such mode");
    EXPECT_EQ(why(R"({"do":"mode","mode":"QHOVER"})"), "mode: there is no such mode");
    EXPECT_EQ(why(R"({"do":"goto","lat_deg":91,"lon_deg":0})"), "lat_deg: expected -90 to 90");
    EXPECT_EQ(why(R"({"do":"goto","lat_deg":1})"), "lon_deg: expected a number");
    EXPECT_EQ(why(R"({"do":"speed","times":0})"), "times: expected 0.1 to 1000");
    EXPECT_EQ(why(R"({"do":"speed","times":"fast"})"), "times: expected a number");
    EXPECT_EQ(why(R"({"do":"wind","speed_mps":31,"from_deg":0})"), "speed_mps: expected 0 to 30");
    EXPECT_EQ(why(R"({"do":"fault","name":"gps_lost"})"), "on: expected true or false");
    EXPECT_THAT(why(R"({"do":"fault","name":"x","on":true})"), testing::HasSubstr("no such fault"));
    EXPECT_EQ(why(R"({"do":"sticks","roll":2,"pitch":0,"throttle":0,"yaw":0})"),
              "roll: expected -1 to 1");
}
