// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/flightgear.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cmath>
#include <cstring>

using namespace simulator;
using namespace simulator::live;

namespace {

// The layout a second time, by FGNetFDM's offsets: doubles at 8, everything else 4 bytes wide.
class Packet {
public:
    explicit Packet(const std::vector<uint8_t>& bytes) : bytes_(bytes) {}
    uint32_t word(size_t at) const { return static_cast<uint32_t>(bits(at, 4)); }
    double real(size_t at) const {
        const uint32_t from = word(at);
        float value;
        std::memcpy(&value, &from, sizeof value);
        return value;
    }
    double wide(size_t at) const {
        const uint64_t from = bits(at, 8);
        double value;
        std::memcpy(&value, &from, sizeof value);
        return value;
    }

private:
    uint64_t bits(size_t at, size_t size) const {
        uint64_t value = 0;
        for (size_t i = 0; i < size; ++i) value = value << 8 | bytes_.at(at + i);
        return value;
    }
    const std::vector<uint8_t>& bytes_;
};

constexpr size_t kLongitude = 8, kLatitude = 16, kAltitude = 24, kAgl = 32, kPhi = 36, kTheta = 40,
                 kPsi = 44, kAlpha = 48, kPhiDot = 56, kPsiDot = 64, kVcas = 68, kClimb = 72,
                 kNorth = 76, kEast = 80, kDown = 84, kBodyU = 88, kAccelZ = 108, kEngines = 120,
                 kEngineState = 124, kRpm = 140, kTanks = 284, kWheels = 304, kWow = 308,
                 kGear = 320, kTime = 356, kVisibility = 364, kElevator = 368, kLeftAileron = 384,
                 kRightAileron = 388, kRudder = 392, kSpoilers = 404;

Truth someTruth() {
    Truth t{};
    t.latitude_deg = 47.3977;
    t.longitude_deg = 8.5456;
    t.altitude_m = 540;
    t.height_m = 52;
    t.roll_rad = 0.3;
    t.pitch_rad = -0.1;
    t.yaw_rad = 1.5;
    t.alpha_rad = 0.05;
    t.velocity_north_mps = 3;
    t.velocity_east_mps = 12;
    t.velocity_down_mps = -2;
    t.yaw_rate_rads = 0.2;
    t.airspeed_mps = 15;
    t.equivalent_airspeed_mps = 14.5;
    t.force_z_mss = -9.81;
    t.throttle = 0.6;
    t.elevator = 0.25;
    t.aileron = -0.5;
    t.rudder = 0.125;
    return t;
}

}  // namespace

TEST(NativeFdm, is_a_packet_of_version_24) {
    const std::vector<uint8_t> bytes = nativeFdm(someTruth(), 1'800'000'000);
    const Packet packet(bytes);

    ASSERT_EQ(bytes.size(), kNativeFdmBytes);
    EXPECT_EQ(packet.word(0), 24u);
    EXPECT_EQ(packet.word(kTime), 1'800'000'000u);
    EXPECT_EQ(packet.real(kVisibility), 20'000);
    EXPECT_EQ(packet.word(kEngines), 1u);
    EXPECT_EQ(packet.word(kEngineState), 2u);
    EXPECT_GT(packet.real(kRpm), 1000);
    EXPECT_EQ(packet.word(kTanks), 0u);
    EXPECT_EQ(packet.word(kWheels), 3u);
    EXPECT_EQ(packet.word(kWow), 0u);
    EXPECT_EQ(packet.real(kGear), 1);
    EXPECT_EQ(packet.real(kSpoilers), 0);
}

TEST(NativeFdm, says_where_the_airplane_is_and_how_it_moves) {
    const std::vector<uint8_t> bytes = nativeFdm(someTruth(), 0);
    const Packet packet(bytes);

    EXPECT_DOUBLE_EQ(packet.wide(kLatitude), 47.3977 * M_PI / 180);
    EXPECT_DOUBLE_EQ(packet.wide(kLongitude), 8.5456 * M_PI / 180);
    EXPECT_EQ(packet.wide(kAltitude), 540);
    EXPECT_FLOAT_EQ(packet.real(kAgl), 52);
    EXPECT_FLOAT_EQ(packet.real(kPhi), 0.3f);
    EXPECT_FLOAT_EQ(packet.real(kTheta), -0.1f);
    EXPECT_FLOAT_EQ(packet.real(kPsi), 1.5f);
    EXPECT_FLOAT_EQ(packet.real(kAlpha), 0.05f);
    EXPECT_NEAR(packet.real(kVcas), 14.5 / 0.514444, 1e-3);
    EXPECT_NEAR(packet.real(kClimb), 2 / 0.3048, 1e-5);
    EXPECT_NEAR(packet.real(kNorth), 3 / 0.3048, 1e-5);
    EXPECT_NEAR(packet.real(kEast), 12 / 0.3048, 1e-5);
    EXPECT_NEAR(packet.real(kDown), -2 / 0.3048, 1e-5);
    EXPECT_NEAR(packet.real(kBodyU), 15 * std::cos(0.05) / 0.3048, 1e-4);
    EXPECT_NEAR(packet.real(kAccelZ), -9.81 / 0.3048, 1e-4);
}

// A turn to the right in a bank: the nose comes round slower than the body's axis turns.
TEST(NativeFdm, gives_rates_of_the_angles) {
    const std::vector<uint8_t> bytes = nativeFdm(someTruth(), 0);
    const Packet packet(bytes);

    EXPECT_NEAR(packet.real(kPsiDot), 0.2 * std::cos(0.3) / std::cos(0.1), 1e-6);
    EXPECT_NEAR(packet.real(kPhiDot), packet.real(kPsiDot) * std::sin(-0.1), 1e-6);
}

TEST(NativeFdm, moves_the_surfaces) {
    const std::vector<uint8_t> bytes = nativeFdm(someTruth(), 0);
    const Packet packet(bytes);

    EXPECT_EQ(packet.real(kElevator), -0.25);
    EXPECT_EQ(packet.real(kLeftAileron), -0.5);
    EXPECT_EQ(packet.real(kRightAileron), 0.5);
    EXPECT_EQ(packet.real(kRudder), 0.125);
}

TEST(NativeFdm, stands_on_its_wheels_with_a_motor_that_is_off) {
    Truth standing{};
    standing.on_ground = true;
    const std::vector<uint8_t> bytes = nativeFdm(standing, 0);
    const Packet packet(bytes);

    for (size_t wheel = 0; wheel < 3; ++wheel) EXPECT_EQ(packet.word(kWow + 4 * wheel), 1u);
    EXPECT_EQ(packet.word(kEngineState), 0u);
}

TEST(FlightGear, is_sent_thirty_packets_a_second) {
    const int receiver = socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    auto* generic = reinterpret_cast<sockaddr*>(&address);
    socklen_t size = sizeof address;
    ASSERT_EQ(bind(receiver, generic, size), 0);
    getsockname(receiver, generic, &size);
    FlightGear view({"127.0.0.1", ntohs(address.sin_port)});

    for (uint64_t now_us = 0; now_us < 2'000'000; now_us += 10'000) view.step(someTruth(), now_us);
    int packets = 0;
    char bytes[1000];
    for (ssize_t got; (got = recv(receiver, bytes, sizeof bytes, MSG_DONTWAIT)) > 0; ++packets)
        EXPECT_EQ(got, static_cast<ssize_t>(kNativeFdmBytes));
    EXPECT_NEAR(packets, 60, 1);
    close(receiver);
}

TEST(FlightGear, has_an_address) {
    EXPECT_EQ(flightGearAddress("localhost:5500")->host, "localhost");
    EXPECT_EQ(flightGearAddress("10.0.0.7:5500")->port, 5500);
    for (const char* wrong : {"", "5500", ":5500", "host:", "host:0", "host:65536", "host:5x",
                              "host:-1", "host:999999999999"})
        EXPECT_FALSE(flightGearAddress(wrong)) << wrong;
}
