// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/gps.hpp"

#include "drivers/gps_script.hpp"
#include "gps_line.hpp"
#include "simulator/devices/mtk_gps.hpp"
#include "simulator/devices/nmea_gps.hpp"
#include "simulator/devices/ublox_gps.hpp"

namespace {

using drivers::GpsFix;
using drivers::GpsFixType;
using drivers::GpsProtocol;
using gps_line::port;

struct Kind {
    const char* name;
    GpsProtocol protocol;
};
constexpr Kind kKinds[] = {{"ublox", GpsProtocol::ublox},     {"ublox_m9", GpsProtocol::ublox},
                           {"ublox_m10", GpsProtocol::ublox}, {"mtk16", GpsProtocol::mtk16},
                           {"mtk19", GpsProtocol::mtk19},     {"nmea", GpsProtocol::nmea}};
constexpr uint32_t kRates[] = {4800, 9600, 19200, 38400, 57600, 115200};

struct GpsOnItsLine : gps_line::Line {
    uint32_t findTime_ms(GpsProtocol protocol, uint32_t max_ms) {
        return flyUntil([&] { return driver.protocol() == protocol; }, max_ms);
    }
};

struct EveryGpsAtEveryRate : GpsOnItsLine,
                             ::testing::WithParamInterface<std::tuple<Kind, uint32_t>> {};

TEST_P(EveryGpsAtEveryRate, is_detected_within_10_s_and_reports_position_and_speed) {
    const auto [kind, baud] = GetParam();
    power(kind.name, baud);
    EXPECT_LT(findTime_ms(kind.protocol, 20'000), 10'000u);
    const bool stays = kind.protocol == GpsProtocol::nmea;
    EXPECT_EQ(port().baud, stays ? baud : 38400);
    EXPECT_EQ(driver.baud(), port().baud);
    fly(5000);
    ASSERT_EQ(driver.protocol(), kind.protocol);
    fixes = 0;
    fly(10'000);

    EXPECT_NEAR(fixes, stays && baud < 38400 ? 10 : 50, 1);
    const GpsFix& fix = driver.fix();
    EXPECT_EQ(fix.type, GpsFixType::three_d);
    EXPECT_NEAR(fix.latitude_e7, -339000000, 10);
    EXPECT_NEAR(fix.longitude_e7, 1512000000, 10);
    EXPECT_NEAR(fix.altitude_cm, 5730, 10);
    EXPECT_NEAR(fix.north_cms, 300, 2);
    EXPECT_NEAR(fix.east_cms, -400, 2);
    EXPECT_NEAR(fix.speed_cms, 500, 1);
    EXPECT_NEAR(fix.course_cd, 30687, 5);
    EXPECT_EQ(fix.satellites, 9);
    EXPECT_EQ(fix.hdop_c, 180);
    EXPECT_EQ(fix.week, 2317);
    EXPECT_EQ(fix.time_ms % 200, 0u);
    EXPECT_EQ(fix.has_down, kind.protocol == GpsProtocol::ublox);
    EXPECT_NEAR(fix.down_cms, fix.has_down ? 50 : 0, 1);
}
INSTANTIATE_TEST_SUITE_P(All, EveryGpsAtEveryRate,
                         ::testing::Combine(::testing::ValuesIn(kKinds),
                                            ::testing::ValuesIn(kRates)),
                         [](const auto& of) {
                             return std::string(std::get<0>(of.param).name) + "_" +
                                    std::to_string(std::get<1>(of.param));
                         });

struct EveryGps : GpsOnItsLine, ::testing::WithParamInterface<Kind> {};
INSTANTIATE_TEST_SUITE_P(All, EveryGps, ::testing::ValuesIn(kKinds),
                         [](const auto& of) { return of.param.name; });

TEST_P(EveryGps, gives_the_same_time_as_the_others) {
    power(GetParam().name, 38400);
    flyUntil([&] { return driver.fix().type == GpsFixType::three_d; }, 10'000);
    const uint32_t age_ms = 34 * 3'600'000u + 18'000 + now_ms - driver.fix().time_ms;

    EXPECT_NEAR(age_ms, driver.fix().age_ms, 12);
}

TEST_P(EveryGps, knows_how_old_its_fix_is) {
    for (uint32_t baud : {9600, 38400, 57600}) {
        power(GetParam().name, baud);
        fly(16'000);
        uint32_t min_ms = UINT32_MAX, max_ms = 0;
        for (int found = 0; found < 5 && now_ms < 200'000;) {
            const int before = fixes;
            fly(10);
            if (fixes == before) continue;
            ++found;
            const uint32_t measured_ms = driver.fix().time_ms - (34 * 3'600'000u + 18'000);
            const uint32_t off_ms = now_ms - measured_ms - driver.fix().age_ms;
            min_ms = std::min(min_ms, off_ms);
            max_ms = std::max(max_ms, off_ms);
        }
        // read in the frame after it came, and at 57600 baud bytes wait for their turn
        EXPECT_LE(max_ms, 16u) << baud;
        EXPECT_GE(min_ms + 2, 2u) << baud;
    }
}

TEST_P(EveryGps, says_when_the_fix_is_lost_and_when_it_is_back) {
    power(GetParam().name, 38400);
    fly(6000);
    gps->cover(true);
    fly(2000);
    EXPECT_TRUE(driver.healthy());
    EXPECT_EQ(driver.fix().type, GpsFixType::none);

    gps->cover(false);
    fly(2000);
    EXPECT_EQ(driver.fix().type, GpsFixType::three_d);
}

TEST_P(EveryGps, is_found_again_after_its_supply_broke_down) {
    power(GetParam().name);
    fly(15'000);
    ASSERT_EQ(driver.protocol(), GetParam().protocol);

    power(GetParam().name);  // everything forgotten
    fly(1000);
    EXPECT_LT(flyUntil([&] { return driver.protocol() == GetParam().protocol; }, 20'000), 10'000u);
    fly(4000);
    EXPECT_EQ(driver.fix().type, GpsFixType::three_d);
}

TEST_P(EveryGps, after_a_pause_is_looked_for_where_it_was) {
    power(GetParam().name, 9600);
    fly(15'000);
    const uint32_t baud = driver.baud();
    auto gone = std::move(gps);
    power("nothing");
    fly(6000);
    EXPECT_FALSE(driver.healthy());
    port().opened.clear();
    const size_t before = port().opened.size();
    while (driver.protocol() != GpsProtocol::none || port().opened.size() == before) fly(10);
    gps = std::move(gone);
    const uint32_t found_ms = findTime_ms(GetParam().protocol, 20'000);

    EXPECT_LT(found_ms, 10'000u);
    EXPECT_EQ(driver.baud(), baud);
}

TEST_P(EveryGps, swapped_for_any_other_one_is_found_within_13_s) {
    for (const Kind& other : kKinds) {
        power(GetParam().name);
        fly(20'000);
        power(other.name);
        flyUntil([&] { return !driver.healthy(); }, 3000);  // silence, or another baud rate
        EXPECT_LT(findTime_ms(other.protocol, 20'000), 10'000u) << other.name;
    }
}

TEST_P(EveryGps, that_is_the_one_set_by_hand_is_found) {
    driver.start(static_cast<uint8_t>(GetParam().protocol) + 1);
    power(GetParam().name, 9600);

    EXPECT_LT(findTime_ms(GetParam().protocol, 20'000), 10'000u);
}

TEST_P(EveryGps, that_is_not_the_one_set_by_hand_is_not_used) {
    for (const Kind& other : kKinds) {
        if (other.protocol == GetParam().protocol) continue;
        driver.start(static_cast<uint8_t>(other.protocol) + 1);
        power(GetParam().name, 38400);
        fly(9000);
        // text is what a receiver sends that nobody configured
        const bool nmea = other.protocol == GpsProtocol::nmea;
        EXPECT_EQ(driver.protocol(), nmea ? GpsProtocol::nmea : GpsProtocol::none) << other.name;
    }
}

TEST_F(GpsOnItsLine, a_ublox_that_talks_at_38400_is_configured_within_2_s) {
    for (bool ubx : {false, true}) {
        simulator::UbloxOptions options;
        static_cast<simulator::GpsOptions&>(options) = poweredNow();
        options.baud = 38400;
        options.ubx = ubx;
        options.nmea = !ubx;
        driver.start();
        const uint32_t began_ms = now_ms;
        plug(std::make_unique<simulator::UbloxGps>(1, simulator::SensorErrors::none(), options));
        fixes = 0;
        flyUntil([&] { return fixes >= 2; }, 5000);
        EXPECT_LT(now_ms - began_ms, 2000u) << ubx;
    }
}

TEST_F(GpsOnItsLine, one_that_nothing_is_plugged_into_is_looked_for_for_ever) {
    power("nothing");
    fly(60'000);

    EXPECT_FALSE(driver.healthy());
    EXPECT_EQ(fixes, 0);
    EXPECT_GT(port().opened.size(), 50u);
}

TEST_F(GpsOnItsLine, type_0_leaves_the_port_alone) {
    driver.start(drivers::gps_none);
    power("ublox");
    fly(5000);

    EXPECT_FALSE(driver.healthy());
    EXPECT_TRUE(port().opened.empty());
}

TEST_F(GpsOnItsLine, an_nmea_receiver_that_could_do_more_is_asked_again) {
    // a u-blox whose first ears were not open yet
    power("nmea", 9600);
    fly(5000);
    ASSERT_EQ(driver.protocol(), GpsProtocol::nmea);
    power("ublox", 9600);

    EXPECT_LT(findTime_ms(GpsProtocol::ublox, 20'000), 9000u);
}

TEST_F(GpsOnItsLine, its_own_words_coming_back_are_no_receiver) {
    power("nothing");
    for (int i = 0; i < 2000; ++i) {
        const auto spoken = port().out;
        fly(10);
        port().receive(port().out);
        ASSERT_FALSE(driver.healthy()) << now_ms;
    }
}

TEST_F(GpsOnItsLine, an_mtk_that_knows_only_text_is_used_with_text) {
    // like a u-blox it takes its rate, but no binary message
    simulator::NmeaOptions options;
    static_cast<simulator::GpsOptions&>(options) = poweredNow();
    options.baud = 38400;
    options.period_ms = 200;
    options.few = true;
    options.talker = "GP";
    plug(std::make_unique<simulator::NmeaGps>(1, simulator::SensorErrors::none(), options));
    fly(6000);

    EXPECT_EQ(driver.protocol(), GpsProtocol::nmea);
    EXPECT_EQ(driver.fix().type, GpsFixType::three_d);
}

TEST_F(GpsOnItsLine, every_seventh_byte_lost_finds_nothing_false) {
    power("mtk16");
    for (int i = 0; i < 3000; ++i) {
        fly(10);
        ASSERT_TRUE(driver.protocol() != GpsProtocol::ublox &&
                    driver.protocol() != GpsProtocol::mtk19);
    }
}

struct Gps : gps_line::Driver {};

TEST_F(Gps, a_line_that_takes_nothing_stops_nobody) {
    port().endless = false;
    port().room = 0;
    for (int i = 0; i < 3000; ++i) step();

    EXPECT_FALSE(driver.healthy());
}

TEST_F(Gps, reads_no_more_than_its_share_a_step) {
    step();
    port().receive(std::vector<uint8_t>(500, 0));
    step();

    EXPECT_EQ(port().in.size(), 500u - drivers::Gps::kBytesPerStep);
}

std::string text(const drivers::GpsScript& script) {
    return std::string(reinterpret_cast<const char*>(script.bytes), script.size);
}

TEST(GpsScript, carries_the_checksums_of_the_receiver_description) {
    const drivers::GpsScript greeting = drivers::ubloxGreeting();
    const drivers::GpsScript script = drivers::ubloxConfiguration();

    EXPECT_EQ(greeting.bytes[2 + 26], 0x8D);
    EXPECT_EQ(greeting.bytes[2 + 27], 0x64);
    EXPECT_EQ(script.bytes[2 + 12], 0xDD);
    EXPECT_EQ(script.bytes[2 + 13], 0x68);
    EXPECT_EQ(script.bytes[16 + 9], 0x0E);
    EXPECT_EQ(script.bytes[16 + 10], 0x47);
    const drivers::GpsScript values = drivers::ubloxValues();
    EXPECT_EQ(values.bytes[2 + 4], 38) << "its length";
    EXPECT_EQ(values.size, 2 + 8 + 38);
    EXPECT_NE(text(greeting).find("$PUBX,41,1,0003,0001,38400,0*26\r\n"), std::string::npos);
}

TEST(GpsScript, sends_an_mtk_the_commands_of_its_manual) {
    EXPECT_EQ(text(drivers::mtkConfiguration()),
              "\r\n$PMTK220,200*2C\r\n$PGCMD,16,0,0,0,0,0*6A\r\n$PMTK251,38400*27\r\n"
              "$PMTK313,1*2E\r\n$PMTK301,2*2E\r\n$PMTK397,0*23\r\n");
    EXPECT_EQ(text(drivers::mtkConfiguration()).find(text(drivers::mtkGreeting())), 0u);
}

}  // namespace
