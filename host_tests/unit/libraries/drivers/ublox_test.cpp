// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/ublox.hpp"

#include <cstring>

#include "drivers/gps_script.hpp"
#include "gps_line.hpp"

namespace {

using drivers::GpsFix;
using drivers::GpsFixType;
using drivers::GpsProtocol;
using gps_line::port;

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
std::vector<uint8_t> velned(uint32_t time_ms, int32_t north_cms = 1234) {
    std::vector<uint8_t> p(36);
    put<uint32_t>(p, 0, time_ms);
    put<int32_t>(p, 4, north_cms);
    return frame(1, 0x12, p);
}

struct UbloxBytes : gps_line::Bytes {
    UbloxBytes() {
        receive(status(100));
        receive(status(100));
        EXPECT_EQ(driver.protocol(), GpsProtocol::ublox);
        port().out.clear();
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
    EXPECT_EQ(driver.refused(), 40);
    EXPECT_EQ(receive(velned(1000)), 1);
}

TEST_F(UbloxBytes, noise_before_and_between_frames_is_stepped_over) {
    std::vector<uint8_t> noise = {0xB5, 0xB5, 0x62, 0xFF, 0xFF, 0xFF, 0xFF, '$', 'G', 'P', 0xB5};
    receive(noise);
    receive(status(1000));
    receive(noise);
    receive(posllh(1000));
    receive(std::vector<uint8_t>{0xB5});
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
        EXPECT_EQ(fix.north_cms, 150);
        EXPECT_EQ(fix.east_cms, -250);
        EXPECT_EQ(fix.speed_cms, 292);
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
    EXPECT_EQ(port().out.size(),
              drivers::ubloxValues().size + size_t{drivers::ubloxConfiguration().size});

    port().out.clear();
    navigation[2] = 8;
    receive(frame(6, 0x24, navigation));
    for (int i = 0; i < 20; ++i) step();
    EXPECT_TRUE(port().out.empty());
}

TEST_F(UbloxBytes, one_message_alone_finds_nothing) {
    driver.start();
    for (int i = 0; i < 60; ++i) step();
    receive(status(1000));
    EXPECT_FALSE(driver.healthy());
    receive(status(1200));
    EXPECT_TRUE(driver.healthy());
}

TEST_F(UbloxBytes, text_between_its_messages_is_not_listened_to) {
    for (int i = 0; i < 5; ++i) {
        receive(std::string("$GPGSA,A,3,,,,,,,,,,,,,1,1,1*1D\r\n"));
        receive(status(1000));
    }
    EXPECT_EQ(driver.protocol(), GpsProtocol::ublox);
}

TEST_F(UbloxBytes, a_message_cut_short_costs_no_other) {
    receive(status(1000));
    const std::vector<uint8_t> cut = posllh(1000);
    for (size_t size = 1; size < cut.size(); ++size) {
        const uint32_t time_ms = 2000 + 200 * static_cast<uint32_t>(size);
        receive(std::vector<uint8_t>(cut.begin(), cut.begin() + static_cast<long>(size)));
        receive(posllh(time_ms));
        EXPECT_EQ(receive(velned(time_ms)), 1) << size;
    }
}

TEST_F(UbloxBytes, a_speed_no_airplane_flies_is_no_fix) {
    receive(status(1000));
    receive(posllh(1000));
    EXPECT_EQ(receive(velned(1000, 40000)), 1);

    EXPECT_EQ(driver.fix().type, GpsFixType::none);
    EXPECT_EQ(driver.refused(), 1);
}

}  // namespace
