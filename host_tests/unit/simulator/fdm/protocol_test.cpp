// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/fdm/protocol.hpp"

#include <gmock/gmock.h>

#include "simulator/fdm/json_model.hpp"

using namespace simulator;
using testing::ElementsAre;
using testing::HasSubstr;

namespace {

constexpr char kState[] =
    "\n{\"timestamp\":2500,\"imu\":{\"gyro\":[0.1,0.2,0.3],\"accel_body\":[1,2,-9]},"
    "\"position\":[10,20,-30],\"attitude\":[0,0,0],\"velocity\":[3,4,5]}\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

// With another field.
std::string with(const std::string& field) {
    return replaced(kState, "\"velocity\"", field + ",\"velocity\"");
}

std::string complaint(const std::string& datagram) {
    try {
        readModelState(datagram);
    } catch (const ModelStateError& error) {
        return error.what();
    }
    return "";
}

struct Nonsense {
    std::string datagram, says;
};
class NonsenseState : public testing::TestWithParam<Nonsense> {};

}  // namespace

TEST(ServoPacket, has_the_forty_bytes_of_the_protocol) {
    std::array<uint16_t, kPacketPulses> pulses{};
    pulses[0] = 1500;
    pulses[15] = 0x1234;
    const auto packet = servoPacket(400, 0x01020304, pulses);

    ASSERT_EQ(packet.size(), 40u);
    EXPECT_THAT(std::vector<uint8_t>(packet.begin(), packet.begin() + 10),
                ElementsAre(0x1A, 0x48, 0x90, 0x01, 4, 3, 2, 1, 0xDC, 0x05));
    EXPECT_EQ(packet[38], 0x34);
    EXPECT_EQ(packet[39], 0x12);
}

TEST(ModelState, is_read_as_the_protocols_own_example_has_it) {
    const ModelState state = readModelState(kState);

    EXPECT_EQ(state.timestamp_s, 2500);
    EXPECT_EQ(state.rates_rads.y, 0.2);
    EXPECT_EQ(state.force_mss.z, -9);
    EXPECT_EQ(state.position_m.z, -30);
    EXPECT_EQ(state.velocity_mps.x, 3);
    EXPECT_EQ(state.attitude.w, 1);
    EXPECT_FALSE(state.airspeed_mps || state.battery || state.radio_us);
}

TEST(ModelState, takes_the_quaternion_before_the_angles) {
    const auto state =
        readModelState(replaced(kState, "\"velocity\"", "\"quaternion\":[0,0,0,2],\"velocity\""));
    EXPECT_EQ(state.attitude.z, 1);
}

TEST(ModelState, reads_optional_fields_and_ignores_unknown_ones) {
    const auto state = readModelState(
        replaced(kState, "\"velocity\"",
                 "\"airspeed\":12,\"velocity_wind\":[1,2,3],\"battery\":{\"voltage\":11.5,"
                 "\"current\":8},\"rng_1\":4,\"rc\":{\"rc_1\":1510,\"rc_3\":1100,\"rc_9\":1000},"
                 "\"no_time_sync\":1,\"velocity\""));

    EXPECT_EQ(state.airspeed_mps, 12);
    EXPECT_EQ(state.wind_mps.z, 3);
    EXPECT_EQ(state.battery->voltage_v, 11.5);
    EXPECT_THAT(*state.radio_us, ElementsAre(1510, 0, 1100, 0, 0, 0, 0, 0));
}

TEST(ModelState, is_the_last_of_several_lines) {
    EXPECT_EQ(readModelState(std::string("half a li") + kState).timestamp_s, 2500);
    EXPECT_EQ(readModelState(replaced(kState, "2500", "1") + kState).timestamp_s, 2500);
}

TEST_P(NonsenseState, is_refused_with_what_was_expected) {
    EXPECT_THAT(complaint(GetParam().datagram), HasSubstr(GetParam().says));
}

INSTANTIATE_TEST_SUITE_P(
    All, NonsenseState,
    testing::Values(Nonsense{"", "expected a JSON object"}, Nonsense{"hello\x01", "found 'hello?'"},
                    Nonsense{"[1,2]", "a JSON object"},
                    Nonsense{replaced(kState, "timestamp", "time"), "the field timestamp"},
                    Nonsense{replaced(kState, "gyro", "giro"), "the field imu/gyro"},
                    Nonsense{replaced(kState, "imu", "emu"), "the field imu/gyro"},
                    Nonsense{replaced(kState, "attitude", "mood"), "attitude or quaternion"},
                    Nonsense{replaced(kState, "[10,20,-30]", "[10,20]"), "position: expected 3"},
                    Nonsense{replaced(kState, "[10,", "[null,"), "position: expected a number"},
                    Nonsense{replaced(kState, "[10,", "[1e30,"), "what an airplane can do"},
                    Nonsense{replaced(kState, "[10,", "[NaN,"), "expected a JSON object"},
                    Nonsense{replaced(kState, "2500", "\"now\""), "timestamp: expected a number"},
                    Nonsense{replaced(kState, "2500", "1e999"), "expected"},
                    Nonsense{replaced(kState, "\"attitude\":[0,0,0]", "\"quaternion\":[0,0,0,0]"),
                             "of length 0"},
                    Nonsense{with("\"rc\":{\"rc_1\":99}"), "rc/rc_1: expected 800"},
                    Nonsense{replaced(kState, "2500", "1e300"), "timestamp: expected -1"},
                    Nonsense{with("\"airspeed\":1e6"), "airspeed: expected -1000"},
                    Nonsense{with("\"airspeed\":\"13\""), "airspeed: expected a number"},
                    Nonsense{with("\"battery\":12"), "the field battery/voltage"},
                    Nonsense{with("\"battery\":{\"voltage\":-4,\"current\":1}"),
                             "battery/voltage: expected 0"},
                    Nonsense{with("\"battery\":{\"voltage\":4,\"current\":1e9}"),
                             "battery/current: expected -1000"},
                    Nonsense{with("\"velocity_wind\":[1,2]"), "velocity_wind: expected 3"}));

TEST(ModelAddress, is_a_port_or_a_host_and_a_port) {
    EXPECT_EQ(modelAddress("json:9002")->port, 9002);
    EXPECT_EQ(modelAddress("json:9002")->host, "127.0.0.1");
    EXPECT_EQ(modelAddress("json:pc:9002")->host, "pc");
    for (const char* wrong : {"9002", "json:", "json:0", "json:65535", "json:-1", "json::9002",
                              "json:9002x", "xml:9002", "json:999999"})
        EXPECT_FALSE(modelAddress(wrong)) << wrong;
}
