// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/mtk.hpp"

#include <vector>

#include "gps_line.hpp"

namespace {

using drivers::GpsEpoch;
using drivers::GpsFixType;
using drivers::GpsProtocol;

struct Message {
    int32_t latitude = 47123456, longitude = -8654321, altitude_cm = 48812;
    int32_t speed_cms = 1500, course_cd = 9000;
    uint8_t satellites = 8, fix = 3;
    uint32_t date = 60124, time = 23595980;  // 2024-01-06, a Saturday
    uint16_t hdop = 112;

    std::vector<uint8_t> bytes(uint8_t first) const {
        std::vector<uint8_t> to = {first, 0xDD, 32};
        const auto put = [&to](uint32_t value, int size) {
            for (; size > 0; --size, value >>= 8) to.push_back(static_cast<uint8_t>(value));
        };
        for (int32_t value : {latitude, longitude, altitude_cm, speed_cms, course_cd})
            put(static_cast<uint32_t>(value), 4);
        put(satellites, 1);
        put(fix, 1);
        put(date, 4);
        put(time, 4);
        put(hdop, 2);
        uint8_t a = 0, b = 0;
        for (size_t i = 2; i < to.size(); ++i)
            b = static_cast<uint8_t>(b + (a = static_cast<uint8_t>(a + to[i])));
        to.push_back(a);
        to.push_back(b);
        return to;
    }
};

struct Mtk : ::testing::Test {
    GpsEpoch epoch{};
    const drivers::GpsFix& read16(const Message& message) {
        EXPECT_TRUE(drivers::readMtk16(message.bytes(0xD0).data(), epoch));
        return epoch.fix;
    }
};

TEST_F(Mtk, of_version_1_6_resolves_millionths_of_a_degree_and_hundredths_of_a_second) {
    const drivers::GpsFix& fix = read16(Message());

    EXPECT_EQ(fix.type, GpsFixType::three_d);
    EXPECT_EQ(fix.latitude_e7, 471234560);
    EXPECT_EQ(fix.longitude_e7, -86543210);
    EXPECT_EQ(fix.altitude_cm, 48812);
    EXPECT_EQ(fix.speed_cms, 1500);
    EXPECT_EQ(fix.course_cd, 9000);
    EXPECT_EQ(fix.north_cms, 0);
    EXPECT_EQ(fix.east_cms, 1500);
    EXPECT_FALSE(fix.has_down);
    EXPECT_EQ(fix.satellites, 8);
    EXPECT_EQ(fix.hdop_c, 112);
}

TEST_F(Mtk, of_version_1_9_resolves_ten_times_finer) {
    Message message;
    message.latitude = 471234567;
    message.longitude = -1796543217;
    message.time = 120000250;
    ASSERT_TRUE(drivers::readMtk19(message.bytes(0xD1).data(), epoch));

    EXPECT_EQ(epoch.fix.latitude_e7, 471234567);
    EXPECT_EQ(epoch.fix.longitude_e7, -1796543217);
    EXPECT_EQ(epoch.fix.time_ms, (6 * 24 + 12) * 3'600'000u + 18'250u);
}

// 18 leap seconds lead from the last second of a Saturday into the next week.
TEST_F(Mtk, makes_gps_time_of_utc) {
    EXPECT_EQ(read16(Message()).week, 2296);  // begins on 2024-01-07
    EXPECT_EQ(epoch.fix.time_ms, 17'800u);

    Message leap_day;
    leap_day.date = 290224;
    leap_day.time = 0;
    EXPECT_EQ(read16(leap_day).week, 2303);
    EXPECT_EQ(epoch.fix.time_ms, 4 * 86'400'000u + 18'000u);

    Message no_date;
    no_date.date = 0;
    no_date.time = 1000;
    EXPECT_EQ(read16(no_date).week, 0);
}

TEST_F(Mtk, has_a_fix_of_two_or_three_dimensions_with_and_without_corrections) {
    const GpsFixType of[] = {GpsFixType::none,    GpsFixType::none,    GpsFixType::two_d,
                             GpsFixType::three_d, GpsFixType::none,    GpsFixType::none,
                             GpsFixType::two_d,   GpsFixType::three_d, GpsFixType::none};
    for (uint8_t reported = 0; reported < 9; ++reported) {
        Message message;
        message.fix = reported;
        EXPECT_EQ(read16(message).type, of[reported]) << int(reported);
    }
}

TEST_F(Mtk, with_a_value_that_cannot_be_is_no_fix_and_counted) {
    const auto with = [](auto change) {
        Message message;
        change(message);
        return message;
    };
    const Message impossible[] = {
        with([](Message& m) { m.latitude = 91'000'000; }),
        with([](Message& m) { m.latitude = INT32_MIN; }),
        with([](Message& m) { m.longitude = 181'000'000; }),
        with([](Message& m) { m.longitude = 429'496'730; }),  // times ten it would fit again
        with([](Message& m) { m.altitude_cm = 6'000'000; }),
        with([](Message& m) { m.speed_cms = 40'000; }),
        with([](Message& m) { m.speed_cms = -1; }),
        with([](Message& m) { m.course_cd = 36'001; }),
        with([](Message& m) { m.course_cd = -1; }),
    };
    uint16_t refused = 0;
    for (const Message& message : impossible) {
        EXPECT_EQ(read16(message).type, GpsFixType::none) << refused;
        EXPECT_EQ(epoch.refused, ++refused);
    }
    EXPECT_EQ(read16(Message()).type, GpsFixType::three_d);
    EXPECT_EQ(epoch.refused, refused);
}

TEST_F(Mtk, without_a_fix_may_report_anything) {
    Message message;
    message.fix = 1;
    message.latitude = message.longitude = message.altitude_cm = INT32_MAX;

    EXPECT_EQ(read16(message).type, GpsFixType::none);
    EXPECT_EQ(epoch.refused, 0);
}

struct MtkBytes : gps_line::Bytes {};

TEST_F(MtkBytes, two_messages_find_it_and_bring_its_configuration) {
    EXPECT_EQ(receive(Message().bytes(0xD0)), 0);
    EXPECT_FALSE(driver.healthy());
    EXPECT_EQ(receive(Message().bytes(0xD0)), 1);
    EXPECT_EQ(driver.protocol(), GpsProtocol::mtk16);
    for (int i = 0; i < 20; ++i) step();
    const std::string reported(gps_line::port().out.begin(), gps_line::port().out.end());
    EXPECT_NE(reported.find("$PGCMD,16,0,0,0,0,0*6A\r\n"), std::string::npos);
    EXPECT_NE(reported.find("$PMTK397,0*23\r\n"), std::string::npos);
}

TEST_F(MtkBytes, one_message_of_each_kind_is_chance) {
    for (int i = 0; i < 4; ++i) {
        receive(Message().bytes(0xD0));
        receive(Message().bytes(0xD1));
    }
    EXPECT_FALSE(driver.healthy());
}

}  // namespace
