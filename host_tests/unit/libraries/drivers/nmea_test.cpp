// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/nmea.hpp"

#include "drivers/gps_framing.hpp"
#include "gps_line.hpp"
#include "simulator/devices/ublox_parser.hpp"

namespace {

using drivers::GpsEpoch;
using drivers::GpsFixType;
using drivers::GpsProtocol;

// The example sentences of the NMEA 0183 literature, one second, one place near Munich.
constexpr char kGga[] = "GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,";
constexpr char kRmc[] = "GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230324,003.1,W";

struct Nmea : ::testing::Test {
    GpsEpoch epoch{};
    drivers::GpsFraming framing;

    // Whole fixes in a sentence as it comes over the line.
    int read(const std::string& body) {
        int fixes = 0;
        for (char c : simulator::nmeaSentence(body))
            for (auto protocol = framing.put(static_cast<uint8_t>(c));
                 protocol != GpsProtocol::none; protocol = framing.next())
                fixes += drivers::readNmea(framing.message(), epoch);
        return fixes;
    }
    GpsFixType type(const std::string& gga, const std::string& rmc) {
        read(gga);
        read(rmc);
        return epoch.fix.type;
    }
};

TEST_F(Nmea, makes_a_fix_of_gga_and_rmc) {
    EXPECT_EQ(read(kGga), 0);
    EXPECT_EQ(read(kRmc), 1);

    const drivers::GpsFix& fix = epoch.fix;
    EXPECT_EQ(fix.type, GpsFixType::three_d);
    EXPECT_EQ(fix.latitude_e7, 481173000);
    EXPECT_EQ(fix.longitude_e7, 115166667);
    EXPECT_EQ(fix.altitude_cm, 54540);
    EXPECT_EQ(fix.satellites, 8);
    EXPECT_EQ(fix.hdop_c, 90);
    EXPECT_EQ(fix.speed_cms, 1152);
    EXPECT_EQ(fix.course_cd, 8440);
    EXPECT_EQ(fix.north_cms, 112);
    EXPECT_EQ(fix.east_cms, 1147);
    EXPECT_FALSE(fix.has_down);
    EXPECT_EQ(fix.week, 2306);
    EXPECT_EQ(fix.time_ms, (6 * 24 + 12) * 3'600'000u + 35 * 60'000u + 19'000u + 18'000u);
}

TEST_F(Nmea, takes_them_in_either_order_and_of_any_talker) {
    EXPECT_EQ(read("GNRMC,010203.40,A,3354.00000,S,15112.00000,W,0.02,,010120,,,A"), 0);
    EXPECT_EQ(read("GLGGA,010203.40,3354.00000,S,15112.00000,W,2,14,0.7,-3.2,M,,M,,"), 1);

    EXPECT_EQ(epoch.fix.latitude_e7, -339000000);
    EXPECT_EQ(epoch.fix.longitude_e7, -1512000000);
    EXPECT_EQ(epoch.fix.altitude_cm, -320);
    EXPECT_EQ(epoch.fix.course_cd, 0);
}

TEST_F(Nmea, makes_none_of_sentences_of_two_times) {
    EXPECT_EQ(read("GPGGA,123518,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,"), 0);
    EXPECT_EQ(read(kRmc), 0);
    EXPECT_EQ(read(kGga), 1);
}

TEST_F(Nmea, knows_a_fix_of_two_dimensions) {
    read("GPGSA,A,2,01,02,03,,,,,,,,,,3.0,2.0,2.2");
    EXPECT_EQ(type(kGga, kRmc), GpsFixType::two_d);
    read("GPGSA,A,3,01,02,03,04,,,,,,,,,3.0,2.0,2.2");
    EXPECT_EQ(type(kGga, kRmc), GpsFixType::three_d);
    epoch.type = GpsFixType::unknown;
    EXPECT_EQ(type("GPGGA,123519,4807.038,N,01131.000,E,1,03,0.9,545.4,M,46.9,M,,", kRmc),
              GpsFixType::two_d);
}

TEST_F(Nmea, without_a_fix_says_so_each_time) {
    for (int i = 0; i < 3; ++i) {
        read("GPGGA,,,,,,0,00,99.99,,,,,,");
        EXPECT_EQ(read("GPRMC,,V,,,,,,,,,,N"), 1);
        EXPECT_EQ(epoch.fix.type, GpsFixType::none);
    }
    EXPECT_EQ(type("GPGGA,123519,4807.038,N,01131.000,E,6,08,0.9,545.4,M,46.9,M,,", kRmc),
              GpsFixType::none)
        << "reckoned, not measured";
    EXPECT_EQ(type(kGga, "GPRMC,123519,V,4807.038,N,01131.000,E,022.4,084.4,230324,003.1,W"),
              GpsFixType::none);
    EXPECT_EQ(epoch.refused, 0);
}

TEST_F(Nmea, refuses_and_counts_what_cannot_be) {
    const char* impossible[] = {
        "GPGGA,123519,9907.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,",
        "GPGGA,123519,4861.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,",
        "GPGGA,123519,4807.038,N,18131.000,E,1,08,0.9,545.4,M,46.9,M,,",
        "GPGGA,123519,,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,",
        "GPGGA,123519,-4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,",
        "GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,,M,46.9,M,,",
        "GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545000.4,M,46.9,M,,",
    };
    uint16_t refused = 0;
    for (const char* gga : impossible) {
        EXPECT_EQ(type(gga, kRmc), GpsFixType::none) << gga;
        EXPECT_EQ(epoch.refused, ++refused) << gga;
    }
    for (const char* rmc : {"GPRMC,123519,A,,,,,922.4,084.4,230324,003.1,W",
                            "GPRMC,123519,A,,,,,-22.4,084.4,230324,003.1,W",
                            "GPRMC,123519,A,,,,,22.4,384.4,230324,003.1,W"}) {
        EXPECT_EQ(type(kGga, rmc), GpsFixType::none) << rmc;
        EXPECT_EQ(epoch.refused, ++refused) << rmc;
    }
    EXPECT_EQ(type(kGga, kRmc), GpsFixType::three_d);
}

TEST_F(Nmea, leaves_a_sentence_out_that_has_no_numbers_where_they_belong) {
    for (const char* gga : {"GPGGA,12x519,4807.038,N,01131.000,E,1,08,0.9,545.4,M",
                            "GPGGA,123519,48.07.038,N,01131.000,E,1,08,0.9,545.4,M",
                            "GPGGA,123519,4807.038,NN,01131.000,E,1,08,0.9,545.4,M",
                            "GPGGA,99999999999999999999,4807.038,N,01131.000,E,1,08,0.9,5,M"}) {
        const uint16_t before = epoch.refused;
        read(gga);
        EXPECT_EQ(epoch.refused, before + 1) << gga;
        EXPECT_EQ(read(kRmc), 0) << gga;
        epoch.parts = 0;
    }
}

TEST_F(Nmea, takes_as_many_decimals_as_it_needs) {
    read("GPGGA,123519.000,4807.0380000000,N,01131.0000001,E,1,08,0.9111111,545.4999,M");
    EXPECT_EQ(read(kRmc), 1);
    EXPECT_EQ(epoch.fix.latitude_e7, 481173000);
    EXPECT_EQ(epoch.fix.altitude_cm, 54549);
}

TEST_F(Nmea, ends_with_a_sentence_that_is_too_short) {
    EXPECT_EQ(read("GPGGA"), 0);
    EXPECT_EQ(read("GPGGA,123519"), 0);
    EXPECT_EQ(read("GPGSA"), 0);
    EXPECT_EQ(read("GPRMC,123519"), 1);
    EXPECT_EQ(epoch.fix.type, GpsFixType::none);
}

struct NmeaBytes : gps_line::Bytes {};

TEST_F(NmeaBytes, wants_two_sentences_of_a_talker) {
    receive(simulator::nmeaSentence("PMTK001,220,3"));
    receive(simulator::nmeaSentence("PMTK001,251,3"));
    receive(simulator::nmeaSentence("PUBX,00"));
    EXPECT_FALSE(driver.healthy());
    receive(simulator::nmeaSentence("GPGLL,,,,,,V,N"));
    EXPECT_FALSE(driver.healthy());
    receive(simulator::nmeaSentence("GNGSA,A,1,,,,,,,,,,,,,,,"));
    EXPECT_EQ(driver.protocol(), GpsProtocol::nmea);
}

TEST_F(NmeaBytes, a_sentence_full_of_binary_headers_is_no_binary_receiver) {
    std::vector<uint8_t> odd = {'$', 'G', 'P', 0xB5, 0x62, 0x01, 0x02, 0xD0, 0xDD, 0x20, '*', '4'};
    for (int i = 0; i < 100; ++i) receive(odd);
    EXPECT_FALSE(driver.healthy());
}

}  // namespace
