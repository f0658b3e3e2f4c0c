// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/ublox.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "drivers/ublox_script.hpp"
#include "fakes/fakes.hpp"
#include "simulator/devices/ublox_gps.hpp"
#include "simulator/world.hpp"

namespace {

using drivers::GpsFix;
using drivers::GpsFixType;

fakes::Serial& port() { return fakes::serial(hal::Port::gps); }

struct Ublox : ::testing::Test {
    drivers::Ublox driver;
    uint32_t now_ms = 0;
    int fixes = 0;

    Ublox() {
        fakes::reset();
        driver.start();
    }
    bool step() {
        now_ms += 10;
        const bool fresh = driver.step(now_ms);
        fixes += fresh;
        return fresh;
    }
};

// ---- against the simulator's receiver, on a line with rates

struct UbloxOnItsLine : Ublox {
    simulator::Truth truth{};
    std::unique_ptr<simulator::UbloxGps> gps;

    UbloxOnItsLine() {
        truth.latitude_deg = -33.9;
        truth.longitude_deg = 151.2;
        truth.altitude_m = 57.3;
        truth.velocity_north_mps = 3;
        truth.velocity_east_mps = -4;
        truth.velocity_down_mps = 0.5;
    }
    void power(uint32_t baud, bool ubx = false) {
        simulator::UbloxOptions options;
        options.baud = baud;
        options.ubx = ubx;
        options.nmea = !ubx;
        options.acquire_s = 0.5;
        gps = std::make_unique<simulator::UbloxGps>(1, simulator::SensorErrors::none(), options);
        power_us = now_ms * 1000ull;
    }
    uint64_t power_us = 0;
    double sent = 0;  // bytes the line has had time for

    void fly(uint32_t for_ms) {
        for (uint32_t ms = 0; ms < for_ms; ms += 10) {
            for (int i = 1; i <= 10; ++i) exchange(now_ms * 1000ull + i * 1000ull - power_us);
            step();
        }
    }
    void exchange(uint64_t now_us) {
        truth.time_us = now_us;
        if (gps->nextEvent_us() <= now_us) gps->run(truth, now_us);
        sent = port().out.empty() ? 0 : sent + port().baud / 10000.0;
        while (sent >= 1 && !port().out.empty()) {
            gps->receive(port().out.front(), port().baud, now_us);
            port().out.erase(port().out.begin());
            sent -= 1;
        }
        while (const auto byte = gps->nextByte(now_us)) {
            const bool heard = std::abs(gps->baud() / double(port().baud) - 1) < 0.04;
            port().in.push_back(heard ? *byte : static_cast<uint8_t>(*byte * 7 + 3));
        }
    }
};

struct UbloxAtEveryRate : UbloxOnItsLine, ::testing::WithParamInterface<uint32_t> {};

TEST_P(UbloxAtEveryRate, is_found_and_set_to_five_fixes_a_second) {
    power(GetParam());
    fly(12000);
    ASSERT_TRUE(driver.healthy());
    fixes = 0;

    fly(10000);

    EXPECT_NEAR(fixes, 50, 1);
    EXPECT_EQ(port().baud, 38400u);
    EXPECT_EQ(driver.fix().type, GpsFixType::three_d);
}
INSTANTIATE_TEST_SUITE_P(Rates, UbloxAtEveryRate,
                         ::testing::Values(4800, 9600, 19200, 38400, 57600, 115200));

TEST_F(UbloxOnItsLine, as_delivered_by_the_factory_has_a_fix_within_5_s) {
    power(9600);
    fly(5000);

    EXPECT_GT(fixes, 0);
}

TEST_F(UbloxOnItsLine, tells_place_and_velocity_in_our_units) {
    power(38400, true);
    fly(4000);

    const GpsFix& fix = driver.fix();
    EXPECT_NEAR(fix.latitude_e7, -339000000, 2);
    EXPECT_NEAR(fix.longitude_e7, 1512000000, 2);
    EXPECT_NEAR(fix.altitude_cm, 5730, 2);
    EXPECT_NEAR(fix.velocity_mps.x, 3, 0.011);
    EXPECT_NEAR(fix.velocity_mps.y, -4, 0.011);
    EXPECT_NEAR(fix.velocity_mps.z, 0.5, 0.011);
    EXPECT_NEAR(fix.ground_speed_mps, 5, 0.011);
    EXPECT_NEAR(fix.course_cd, 30687, 5);
    EXPECT_EQ(fix.satellites, 9);
    EXPECT_GT(fix.hdop_c, 0);
}

TEST_F(UbloxOnItsLine, says_when_the_fix_is_lost_and_when_it_is_back) {
    power(38400, true);
    fly(3000);
    gps->cover(true);
    fly(2000);
    EXPECT_TRUE(driver.healthy());
    EXPECT_EQ(driver.fix().type, GpsFixType::none);

    gps->cover(false);
    fly(2000);
    EXPECT_EQ(driver.fix().type, GpsFixType::three_d);
}

TEST_F(UbloxOnItsLine, is_found_again_after_its_supply_broke_down) {
    power(9600);
    fly(8000);
    ASSERT_TRUE(driver.healthy());

    power(9600);  // everything forgotten
    fly(2000);
    EXPECT_FALSE(driver.healthy());
    fly(8000);
    EXPECT_TRUE(driver.healthy());
    fixes = 0;
    fly(2000);
    EXPECT_NEAR(fixes, 10, 1);
}

// ---- byte by byte

std::vector<uint8_t> frame(uint8_t of_class, uint8_t id, const std::vector<uint8_t>& payload) {
    std::vector<uint8_t> bytes;
    const uint8_t head[] = {0xB5, 0x62, of_class, id, static_cast<uint8_t>(payload.size()), 0};
    for (uint8_t byte : head) bytes.push_back(byte);
    for (uint8_t byte : payload) bytes.push_back(byte);
    uint8_t a = 0, b = 0;
    for (size_t i = 2; i < bytes.size(); ++i)
        b = static_cast<uint8_t>(b + (a = static_cast<uint8_t>(a + bytes[i])));
    bytes.push_back(a);
    bytes.push_back(b);
    return bytes;
}
template <class T>
void put(std::vector<uint8_t>& payload, size_t at, T value) {
    std::memcpy(payload.data() + at, &value, sizeof value);
}
std::vector<uint8_t> posllh(uint32_t time_ms, int32_t latitude_e7 = 473977000) {
    std::vector<uint8_t> p(28);
    put<uint32_t>(p, 0, time_ms);
    put<int32_t>(p, 4, 85456000);
    put<int32_t>(p, 8, latitude_e7);
    put<int32_t>(p, 16, 488000);
    return frame(1, 2, p);
}
std::vector<uint8_t> status(uint32_t time_ms, uint8_t type = 3, uint8_t flags = 1) {
    std::vector<uint8_t> p(16);
    put<uint32_t>(p, 0, time_ms);
    p[4] = type;
    p[5] = flags;
    return frame(1, 3, p);
}
std::vector<uint8_t> velned(uint32_t time_ms) {
    std::vector<uint8_t> p(36);
    put<uint32_t>(p, 0, time_ms);
    put<int32_t>(p, 4, 1234);
    return frame(1, 0x12, p);
}

struct UbloxBytes : Ublox {
    UbloxBytes() {
        for (int i = 0; i < 40; ++i) step();  // past the greeting
        port().out.clear();
    }
    int receive(const std::vector<uint8_t>& bytes) {
        port().receive(bytes);
        const int before = fixes;
        while (!port().in.empty()) step();
        step();
        return fixes - before;
    }
};

TEST_F(UbloxBytes, a_fix_needs_place_and_velocity_of_one_epoch) {
    receive(status(1000));
    EXPECT_EQ(receive(posllh(1000)), 0);
    EXPECT_EQ(receive(velned(1200)), 0);
    EXPECT_EQ(receive(posllh(1200)), 1);
    EXPECT_EQ(receive(posllh(1400)), 0);
    EXPECT_EQ(receive(velned(1400)), 1);
    EXPECT_EQ(receive(velned(1400)), 0);
}

TEST_F(UbloxBytes, a_wrong_checksum_is_counted_and_nothing_else) {
    receive(status(1000));
    for (size_t i = 2; i < 44; ++i) {
        if (i == 4 || i == 5) continue;  // another length: seen as noise, below
        std::vector<uint8_t> bad = velned(1000);
        bad[i] ^= 0x10;
        receive(posllh(1000));
        EXPECT_EQ(receive(bad), 0) << i;
    }
    EXPECT_EQ(driver.checksumErrors(), 40);
    EXPECT_EQ(receive(velned(1000)), 1);
}

TEST_F(UbloxBytes, noise_before_and_between_frames_is_stepped_over) {
    std::vector<uint8_t> noise = {0xB5, 0xB5, 0x62, 0xFF, 0xFF, 0xFF, 0xFF, '$', 'G', 'P', 0xB5};
    receive(noise);
    receive(status(1000));
    receive(noise);
    receive(posllh(1000));
    receive({0xB5});
    EXPECT_EQ(receive(velned(1000)), 1);
}

TEST_F(UbloxBytes, a_fix_the_receiver_does_not_vouch_for_is_none) {
    receive(status(1000, 3, 0));
    receive(posllh(1000));
    EXPECT_EQ(receive(velned(1000)), 1);
    EXPECT_EQ(driver.fix().type, GpsFixType::none);

    receive(status(1200, 2, 1));
    receive(posllh(1200));
    receive(velned(1200));
    EXPECT_EQ(driver.fix().type, GpsFixType::two_d);
}

TEST_F(UbloxBytes, a_place_that_is_not_on_earth_is_no_fix) {
    receive(status(1000));
    receive(posllh(1000, 1000000000));
    EXPECT_EQ(receive(velned(1000)), 1);

    EXPECT_EQ(driver.fix().type, GpsFixType::none);
}

TEST_F(UbloxBytes, the_one_message_of_newer_receivers_does_as_well) {
    for (size_t size : {84, 92}) {
        std::vector<uint8_t> p(size);
        put<uint32_t>(p, 0, 1000 + static_cast<uint32_t>(size));
        p[20] = 3;
        p[21] = 1;
        p[23] = 11;
        put<int32_t>(p, 24, -1225000000);
        put<int32_t>(p, 28, 377000000);
        put<int32_t>(p, 36, 12340);
        put<int32_t>(p, 48, 1500);
        put<int32_t>(p, 52, -2500);
        put<int32_t>(p, 60, 2915);
        put<int32_t>(p, 64, 30096375);
        put<uint16_t>(p, 76, 180);
        EXPECT_EQ(receive(frame(1, 7, p)), 1);
        const GpsFix& fix = driver.fix();
        EXPECT_EQ(fix.longitude_e7, -1225000000);
        EXPECT_EQ(fix.latitude_e7, 377000000);
        EXPECT_EQ(fix.altitude_cm, 1234);
        EXPECT_FLOAT_EQ(fix.velocity_mps.x, 1.5f);
        EXPECT_FLOAT_EQ(fix.velocity_mps.y, -2.5f);
        EXPECT_FLOAT_EQ(fix.ground_speed_mps, 2.915f);
        EXPECT_EQ(fix.course_cd, 30096);
        EXPECT_EQ(fix.satellites, 11);
        EXPECT_EQ(fix.hdop_c, 180);
        EXPECT_EQ(fix.type, GpsFixType::three_d);
    }
}

TEST_F(UbloxBytes, silence_turns_it_unhealthy_and_the_search_begins_at_38400) {
    receive(status(1000));
    EXPECT_TRUE(driver.healthy());
    port().opened.clear();
    for (int i = 0; i < 130; ++i) step();

    EXPECT_FALSE(driver.healthy());
    ASSERT_FALSE(port().opened.empty());
    EXPECT_EQ(port().opened.front(), 38400u);
}

TEST_F(UbloxBytes, three_seconds_without_five_fixes_a_second_bring_the_configuration_again) {
    receive(status(1000));
    for (int i = 0; i < 20; ++i) step();
    port().out.clear();
    for (uint32_t second = 1; second < 17; ++second) {
        receive(posllh(1000 * second));
        receive(velned(1000 * second));
        for (int i = 0; i < 90; ++i) step();
    }

    EXPECT_GE(port().out.size(), drivers::ubloxConfiguration().size);
}

TEST_F(UbloxBytes, another_model_than_airborne_4g_brings_the_configuration_again) {
    receive(status(1000));
    for (int i = 0; i < 20; ++i) step();
    port().out.clear();
    std::vector<uint8_t> navigation(36);
    navigation[2] = 3;
    receive(frame(6, 0x24, navigation));
    for (int i = 0; i < 20; ++i) step();
    EXPECT_EQ(port().out.size(), drivers::ubloxConfiguration().size);

    port().out.clear();
    navigation[2] = 8;
    receive(frame(6, 0x24, navigation));
    for (int i = 0; i < 20; ++i) step();
    EXPECT_TRUE(port().out.empty());
}

TEST_F(UbloxBytes, reads_no_more_than_its_share_a_step) {
    port().receive(std::vector<uint8_t>(500, 0));
    step();

    EXPECT_EQ(port().in.size(), 500u - drivers::Ublox::kBytesPerStep);
}

TEST_F(Ublox, a_line_that_takes_nothing_stops_nobody) {
    port().room = 0;
    for (int i = 0; i < 1000; ++i) step();

    EXPECT_FALSE(driver.healthy());
}

TEST(UbloxScript, carries_the_checksums_of_the_receiver_description) {
    const drivers::UbloxScript greeting = drivers::ubloxGreeting();
    const drivers::UbloxScript script = drivers::ubloxConfiguration();

    EXPECT_EQ(greeting.bytes[2 + 26], 0x8D);
    EXPECT_EQ(greeting.bytes[2 + 27], 0x64);
    EXPECT_EQ(script.bytes[2 + 12], 0xDD);
    EXPECT_EQ(script.bytes[2 + 13], 0x68);
    EXPECT_EQ(script.bytes[16 + 9], 0x0E);
    EXPECT_EQ(script.bytes[16 + 10], 0x47);
}

}  // namespace
