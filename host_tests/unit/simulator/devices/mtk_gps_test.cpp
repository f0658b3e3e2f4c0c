// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simulator/devices/mtk_gps.hpp"
#include "simulator/devices/nmea_gps.hpp"
#include "simulator/world.hpp"

using namespace simulator;

namespace {

struct Bench {
    explicit Bench(std::unique_ptr<GpsReceiver> receiver) : gps(std::move(receiver)) {
        truth.latitude_deg = 47.3977;
        truth.longitude_deg = -8.5456;
        truth.altitude_m = 488;
        truth.velocity_east_mps = 10;
    }
    std::string runFor(uint64_t us) {
        std::string heard;
        for (const uint64_t end_us = now_us + us; now_us < end_us; now_us += 1000) {
            if (gps->nextEvent_us() <= now_us) gps->run(truth, now_us);
            while (const auto byte = gps->nextByte(now_us)) heard += static_cast<char>(*byte);
        }
        return heard;
    }
    void say(const std::string& body, uint32_t baud) {
        for (char c : nmeaSentence(body)) gps->receive(static_cast<uint8_t>(c), baud, now_us);
    }

    std::unique_ptr<GpsReceiver> gps;
    Truth truth{};
    uint64_t now_us = 0;
};

Bench mtk(bool version_19) {
    MtkOptions options;
    options.version_19 = version_19;
    options.acquire_s = 0;
    return Bench(std::make_unique<MtkGps>(1, SensorErrors::none(), options));
}
int32_t i32(const std::string& bytes, size_t at) {
    uint32_t value = 0;
    for (size_t i = 4; i-- > 0;) value = value << 8 | static_cast<uint8_t>(bytes.at(at + i));
    return static_cast<int32_t>(value);
}
int count(const std::string& in, const std::string& what) {
    int found = 0;
    for (size_t at = in.find(what); at != in.npos; at = in.find(what, at + 1)) ++found;
    return found;
}

TEST(MtkGps, starts_with_text_once_a_second_and_obeys_its_orders) {
    Bench bench = mtk(false);
    const std::string text = bench.runFor(5'100'000);
    EXPECT_EQ(count(text, "$GPGGA"), 4);
    EXPECT_EQ(count(text, "$GPRMC"), 4);

    bench.say("PMTK220,200", 38400);
    bench.say("PMTK220,100", 38400);
    bench.say("PMTK999,1", 38400);
    EXPECT_NE(
        bench.runFor(100'000).find("$PMTK001,220,3*30\r\n$PMTK001,220,2*31\r\n$PMTK001,999,2"),
        std::string::npos);
    bench.say("PGCMD,16,0,0,0,0,0", 38400);
    bench.runFor(1'000'000);
    EXPECT_EQ(count(bench.runFor(2'000'000), "\xD0\xDD\x20"), 10);
    bench.say("PGCMD,16,1,1,1,1,1", 38400);
    bench.runFor(300'000);
    EXPECT_EQ(count(bench.runFor(1'000'000), "$GPGGA"), 5);
}

TEST(MtkGps, understands_nothing_at_another_rate_and_changes_its_own_by_order) {
    Bench bench = mtk(false);
    bench.say("PMTK251,9600", 57600);
    EXPECT_EQ(bench.gps->baud(), 38400u);
    bench.say("PMTK251,9600", 38400);
    EXPECT_EQ(bench.gps->baud(), 9600u);
    bench.say("PMTK251,12", 9600);
    EXPECT_EQ(bench.gps->baud(), 9600u);
}

TEST(MtkGps, reports_the_state_in_the_scale_of_its_version) {
    for (bool version_19 : {false, true}) {
        Bench bench = mtk(version_19);
        bench.say("PGCMD,16,0,0,0,0,0", 38400);
        const std::string bytes = bench.runFor(1'400'000);
        const size_t at = bytes.find(version_19 ? "\xD1\xDD\x20" : "\xD0\xDD\x20");
        ASSERT_NE(at, std::string::npos);
        EXPECT_EQ(i32(bytes, at + 3), version_19 ? 473977000 : 47397700);
        EXPECT_EQ(i32(bytes, at + 7), version_19 ? -85456000 : -8545600);
        EXPECT_EQ(i32(bytes, at + 11), 48800);
        EXPECT_EQ(i32(bytes, at + 15), 1000);
        EXPECT_EQ(i32(bytes, at + 19), 9000);
        EXPECT_EQ(i32(bytes, at + 25), 30624);
        EXPECT_EQ(i32(bytes, at + 29), version_19 ? 100001000 : 10000100);
    }
}

TEST(NmeaGps, sends_its_sentences_and_listens_to_nobody) {
    NmeaOptions options;
    options.acquire_s = 0;
    Bench bench(std::make_unique<NmeaGps>(1, SensorErrors::none(), options));
    bench.say("PMTK251,38400", 9600);
    const std::string text = bench.runFor(3'600'000);
    EXPECT_EQ(bench.gps->baud(), 9600u);
    for (const char* sentence : {"$GNGGA,1000", "$GNGSA,A,3", "$GNRMC,1000", "$GNVTG,90.00"})
        EXPECT_EQ(count(text, sentence), 3) << sentence;
}

TEST(World, lets_another_gps_be_plugged_in) {
    WorldOptions options;
    World world(options);
    world.advanceTo(5'000'000);
    EXPECT_EQ(world.gps().baud(), 9600u);
    world.plugGps("mtk16");
    EXPECT_EQ(world.gps().baud(), 38400u);
    world.advanceTo(6'100'000);
    EXPECT_EQ(world.gps().nextByte_us(), UINT64_MAX);
    world.advanceTo(6'300'000);
    EXPECT_LT(world.gps().nextByte_us(), 6'300'000u);
    world.plugGps("nothing");
    world.advanceTo(20'000'000);
    EXPECT_EQ(world.gps().nextByte_us(), UINT64_MAX);
}

}  // namespace
