// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simulator/airplane/earth.hpp"
#include "simulator/devices/ublox_gps.hpp"
#include "simulator/world.hpp"
#include "statistics.hpp"

using namespace simulator;

namespace {

Truth place() {
    Truth truth{};
    truth.latitude_deg = 47.3977;
    truth.longitude_deg = 8.5456;
    truth.altitude_m = 488;
    return truth;
}

UbloxOptions ready() {
    UbloxOptions options;
    options.baud = 38400;
    options.nmea = false;
    options.ubx = true;
    options.acquire_s = 0;
    return options;
}

struct Received {
    UbxFrame frame;
    uint64_t time_us;
};

// The module on its line, time going on event by event.
struct Bench {
    explicit Bench(UbloxOptions options = {}, SensorErrors errors = SensorErrors::none(),
                   uint64_t seed = 1)
        : gps(seed, errors, options) {}

    void runUntil(uint64_t end_us) {
        for (;;) {
            const uint64_t next_us = std::min(gps.nextEvent_us(), gps.nextByte_us());
            if (next_us > end_us) break;
            now_us = next_us;
            if (truth_at) truth = truth_at(now_us);
            if (gps.nextEvent_us() <= now_us) gps.run(truth, now_us);
            while (const auto byte = gps.nextByte(now_us)) take(*byte);
        }
        now_us = end_us;
    }
    void take(uint8_t byte) {
        bytes.push_back(static_cast<char>(byte));
        parser.take(byte);
        if (const auto frame = parser.frame()) frames.push_back({*frame, now_us});
        if (const auto sentence = parser.sentence()) sentences.push_back(*sentence);
    }
    void send(const std::vector<uint8_t>& out, uint32_t baud) {
        for (uint8_t byte : out) gps.receive(byte, baud, now_us);
    }
    void send(const std::string& out, uint32_t baud) {
        send(std::vector<uint8_t>(out.begin(), out.end()), baud);
    }
    // Configures and returns the id of what came back: 1 ACK, 0 NAK, -1 nothing.
    int configure(const UbxFrame& frame) {
        frames.clear();
        send(ubxBytes(frame), gps.baud());
        runUntil(now_us + 100'000);
        for (const Received& r : frames)
            if (r.frame.message_class == 5) {
                EXPECT_EQ(r.frame.payload, (std::vector<uint8_t>{frame.message_class, frame.id}));
                return r.frame.id;
            }
        return -1;
    }
    std::vector<Received> of(uint8_t message_class, uint8_t id) const {
        std::vector<Received> out;
        for (const Received& r : frames)
            if (r.frame.message_class == message_class && r.frame.id == id) out.push_back(r);
        return out;
    }

    UbloxGps gps;
    Truth truth = place();
    std::function<Truth(uint64_t)> truth_at;
    UbloxParser parser;
    std::vector<Received> frames;
    std::vector<std::string> sentences;
    std::string bytes;
    uint64_t now_us = 0;
};

int32_t i32(const Received& r, size_t at) { return static_cast<int32_t>(r.frame.u32(at)); }

std::vector<uint8_t> portPayload(uint32_t baud, uint8_t out_mask) {
    std::vector<uint8_t> payload(20);
    payload[0] = 1;
    payload[4] = 0xD0;
    payload[5] = 0x08;
    for (size_t i = 0; i < 4; ++i) payload[8 + i] = static_cast<uint8_t>(baud >> 8 * i);
    payload[12] = 3;
    payload[14] = out_mask;
    return payload;
}

}  // namespace

TEST(UbloxGps, starts_with_nmea_at_9600_baud_once_a_second) {
    Bench bench;
    bench.runUntil(10'900'000);
    EXPECT_EQ(bench.gps.baud(), 9600u);
    EXPECT_TRUE(bench.frames.empty());
    EXPECT_THAT(bench.sentences[0], testing::StartsWith("GPRMC,100001.00,V,"));
    const std::vector<std::string> last(bench.sentences.end() - 8, bench.sentences.end());
    using testing::StartsWith;
    EXPECT_THAT(last,
                testing::ElementsAre(StartsWith("GPRMC,100010.00,A,4723.86200,N,00832.73600,E,"),
                                     StartsWith("GPVTG,"), StartsWith("GPGGA,100010.00,"),
                                     StartsWith("GPGSA,A,3,"), StartsWith("GPGSV,3,1,09,"),
                                     StartsWith("GPGSV,3,2,09,"), StartsWith("GPGSV,3,3,09,"),
                                     StartsWith("GPGLL,4723.86200,N,")));
}

TEST(UbloxGps, finds_its_position_after_the_time_to_acquire) {
    UbloxOptions options = ready();
    options.acquire_s = 3;
    Bench bench(options);
    bench.runUntil(4'900'000);
    for (const Received& r : bench.of(1, 3)) {
        const bool later = r.time_us > 3'200'000;
        EXPECT_EQ(r.frame.payload[4], later ? 3 : 0);
        EXPECT_EQ(r.frame.payload[5] & 1, later);
    }
    EXPECT_EQ(bench.of(1, 3).size(), 23u);
}

TEST(UbloxGps, sends_a_byte_in_ten_bit_times) {
    Bench bench;
    bench.runUntil(1'100'000);
    bench.gps.run(bench.truth, 1'200'000);
    const uint64_t first_us = bench.gps.nextByte_us();
    EXPECT_NEAR(static_cast<double>(first_us), 1'200'000 + 10e6 / 9600, 1);
    EXPECT_FALSE(bench.gps.nextByte(first_us - 1));
    EXPECT_EQ(bench.gps.nextByte(first_us), '$');
    EXPECT_NEAR(static_cast<double>(bench.gps.nextByte_us()), 1'200'000 + 20e6 / 9600, 1);
}

TEST(UbloxGps, understands_nothing_at_another_rate) {
    Bench bench;
    bench.send(ubxBytes({6, 8, {200, 0, 1, 0, 1, 0}}), 38400);
    bench.send("$PUBX,41,1,0003,0001,38400,0*26\r\n", 4800);
    bench.runUntil(900'000);
    EXPECT_EQ(bench.gps.baud(), 9600u);
    EXPECT_EQ(bench.bytes, "");
}

TEST(UbloxGps, understands_the_rate_an_avr_can_make) {
    Bench bench;
    bench.send("$PUBX,41,1,0003,0001,38400,0*26\r\n", 9615);
    EXPECT_EQ(bench.gps.baud(), 38400u);
}

TEST(UbloxGps, changes_rate_and_protocol_by_pubx) {
    Bench bench;
    bench.send("$PUBX,41,1,0003,0001,38400,0*26\r\n", 9600);
    EXPECT_EQ(bench.gps.baud(), 38400u);
    bench.runUntil(3'000'000);
    EXPECT_TRUE(bench.sentences.empty()) << "NMEA is no longer among the protocols out";
}

TEST(UbloxGps, ignores_a_sentence_with_a_wrong_checksum) {
    Bench bench;
    bench.send("$PUBX,41,1,0003,0001,38400,0*27\r\n", 9600);
    EXPECT_EQ(bench.gps.baud(), 9600u);
}

TEST(UbloxGps, understands_a_frame_behind_the_beginning_of_a_sentence) {
    Bench bench;
    bench.send("$PUBX,41,1", 9600);
    EXPECT_EQ(bench.configure({6, 8, {200, 0, 1, 0, 1, 0}}), 1);
}

// DYNMODEL 8, and PVT.
const std::vector<uint8_t> kValues = {0,    1, 0,    0,    0x21, 0x00, 0x11,
                                      0x20, 8, 0x07, 0x00, 0x91, 0x20, 1};

TEST(UbloxGps, takes_values_by_key_from_the_m9_on) {
    for (auto [generation, taken] : {std::pair{UbloxGeneration::six, 0},
                                     {UbloxGeneration::m9, 1},
                                     {UbloxGeneration::m10, 1}}) {
        UbloxOptions options = ready();
        options.generation = generation;
        Bench bench(options);
        EXPECT_EQ(bench.configure({6, 0x8A, kValues}), taken);
        bench.runUntil(bench.now_us + 1'000'000);
        EXPECT_EQ(bench.of(1, 7).empty(), taken == 0);
        std::vector<uint8_t> unknown = kValues;
        unknown[4] = 0x77;
        EXPECT_EQ(bench.configure({6, 0x8A, unknown}), 0);
        std::vector<uint8_t> cut(kValues.begin(), kValues.end() - 1);
        EXPECT_EQ(bench.configure({6, 0x8A, cut}), 0);
    }
}

TEST(UbloxGps, has_no_solution_message_from_the_m9_on_and_an_m10_takes_keys_alone) {
    UbloxOptions options = ready();
    options.generation = UbloxGeneration::m9;
    Bench m9(options);
    EXPECT_EQ(m9.configure({6, 1, {1, 6, 1}}), 0);
    EXPECT_EQ(m9.configure({6, 1, {1, 2, 1}}), 1);
    options.generation = UbloxGeneration::m10;
    Bench m10(options);
    EXPECT_EQ(m10.configure({6, 1, {1, 2, 1}}), 0);
    EXPECT_EQ(m10.configure({6, 0, portPayload(115'200, 1)}), 0);
    EXPECT_EQ(m10.configure({6, 0x24, {}}), 0);
}

TEST(UbloxGps, changes_rate_by_cfg_prt_and_refuses_a_wrong_one) {
    Bench bench;
    EXPECT_EQ(bench.configure({6, 0, portPayload(12, 1)}), 0);
    bench.configure({6, 0, portPayload(115'200, 1)});
    EXPECT_EQ(bench.gps.baud(), 115'200u);
    EXPECT_EQ(bench.configure({6, 0, portPayload(115'200, 1)}), 1);
}

TEST(UbloxGps, enables_messages_one_by_one) {
    Bench bench;
    for (uint8_t id : {0x02, 0x07}) EXPECT_EQ(bench.configure({6, 1, {1, id, 1}}), 1);
    EXPECT_EQ(bench.configure({6, 1, {1, 0x03, 2}}), 1);
    EXPECT_EQ(bench.configure({6, 1, {1, 0x77, 1}}), 0);
    bench.frames.clear();
    bench.runUntil(10'700'000);
    EXPECT_EQ(bench.of(1, 0x02).size(), 10u);
    EXPECT_EQ(bench.of(1, 0x07).size(), 10u);
    EXPECT_EQ(bench.of(1, 0x03).size(), 5u);
    EXPECT_EQ(bench.of(1, 0x12).size(), 0u);
}

TEST(UbloxGps, goes_up_to_five_fixes_a_second_and_no_further) {
    UbloxOptions options = ready();
    options.ubx = false;
    Bench bench(options);
    EXPECT_EQ(bench.configure({6, 8, {100, 0, 1, 0, 1, 0}}), 0);
    EXPECT_EQ(bench.configure({6, 8, {200, 0, 1, 0, 1, 0}}), 1);
    EXPECT_EQ(bench.configure({6, 1, {1, 2, 1}}), 1);
    bench.frames.clear();
    bench.runUntil(bench.now_us + 10'000'000);
    const auto fixes = bench.of(1, 2);
    EXPECT_EQ(fixes.size(), 50u);
    EXPECT_EQ(fixes[1].frame.u32(0) - fixes[0].frame.u32(0), 200u);
}

TEST(UbloxGps, takes_only_the_masked_fields_of_cfg_nav5) {
    Bench bench(ready());
    std::vector<uint8_t> payload(36, 0xEE);
    payload[0] = 1;
    payload[1] = 0;
    payload[2] = 8;
    EXPECT_EQ(bench.configure({6, 0x24, payload}), 1);
    bench.configure({6, 0x24, {}});
    const auto answer = bench.of(6, 0x24);
    ASSERT_EQ(answer.size(), 1u);
    EXPECT_EQ(answer[0].frame.payload[2], 8);
    EXPECT_EQ(answer[0].frame.payload[3], 3);
    EXPECT_EQ(answer[0].frame.payload[12], 5);
    payload[2] = 77;
    EXPECT_EQ(bench.configure({6, 0x24, payload}), 0);
}

TEST(UbloxGps, refuses_configuration_it_does_not_know) {
    Bench bench(ready());
    EXPECT_EQ(bench.configure({6, 0x7E, {1, 2}}), 0);
    EXPECT_EQ(bench.configure({6, 0x16, {}}), 1);
}

TEST(UbloxGps, reports_the_truth_in_every_message) {
    Bench bench(ready());
    bench.truth.velocity_north_mps = 3;
    bench.truth.velocity_east_mps = -4;
    bench.truth.velocity_down_mps = 1;
    bench.configure({6, 1, {1, 7, 1}});
    bench.runUntil(2'000'000);
    const auto position = bench.of(1, 2).back(), velocity = bench.of(1, 0x12).back();
    const auto pvt = bench.of(1, 7).back(), solution = bench.of(1, 6).back();
    EXPECT_NEAR(i32(position, 8), 473'977'000, 1);
    EXPECT_NEAR(i32(position, 4), 85'456'000, 1);
    EXPECT_EQ(i32(position, 16), 488'000);
    EXPECT_EQ(i32(velocity, 4), 300);
    EXPECT_EQ(i32(velocity, 8), -400);
    EXPECT_EQ(i32(velocity, 12), 100);
    EXPECT_EQ(i32(velocity, 20), 500);
    EXPECT_NEAR(i32(velocity, 24), 306.8699e5, 10);
    EXPECT_EQ(pvt.frame.payload.size(), 84u);
    EXPECT_EQ(pvt.frame.u16(4), 2024);
    EXPECT_EQ(pvt.frame.payload[20], 3);
    EXPECT_EQ(i32(pvt, 48), 3000);
    EXPECT_EQ(solution.frame.payload.size(), 52u);
    EXPECT_EQ(solution.frame.payload[47], 9);
    const Vec3 ecef = ecefPosition_m(47.3977, 8.5456, 535);
    EXPECT_NEAR(i32(solution, 12), ecef.x * 100, 1);
    EXPECT_NEAR(i32(solution, 20), ecef.z * 100, 1);
    EXPECT_EQ(position.frame.u32(0), velocity.frame.u32(0));
}

TEST(UbloxGps, loses_its_fix_under_a_cover_and_finds_it_again) {
    Bench bench(ready());
    bench.runUntil(2'000'000);
    bench.gps.cover(true);
    bench.runUntil(3'000'000);
    EXPECT_EQ(bench.of(1, 3).back().frame.payload[4], 0);
    bench.gps.cover(false);
    bench.runUntil(4'000'000);
    EXPECT_EQ(bench.of(1, 3).back().frame.payload[4], 3);
}

TEST(UbloxGps, reports_the_state_of_a_fifth_of_a_second_ago) {
    const SensorErrors errors = SensorErrors::none();
    Bench bench(ready(), errors);
    bench.truth_at = [](uint64_t now_us) {
        Truth truth = place();
        truth.velocity_north_mps = static_cast<double>(now_us) * 1e-6;  // encodes the time
        return truth;
    };
    bench.runUntil(5'000'000);
    for (const Received& r : bench.of(1, 0x12)) {
        const double measured_s = i32(r, 4) / 100.0;
        const double age_s = static_cast<double>(r.time_us) * 1e-6 - measured_s;
        EXPECT_GE(age_s, errors.gps_age_s);
        EXPECT_LT(age_s, errors.gps_age_s + 0.05) << "and the time on the line";
    }
}

TEST(UbloxGps, errs_by_the_wander_and_noise_of_the_table) {
    const SensorErrors errors;
    constexpr double kNorth_m = 6'370'000 * M_PI / 180 * 1e-7;  // per 1e-7 degree, near enough
    const double east_m = kNorth_m * std::cos(47.3977 * M_PI / 180);
    Statistics north[2], east, up[2], velocity;
    for (uint64_t seed = 1; seed <= 600; ++seed) {
        Bench bench(ready(), errors, seed);
        for (int when = 0; when < 2; ++when) {
            bench.frames.clear();
            const auto to = static_cast<uint64_t>(errors.gps_wander_s * 1e6) * when + 500'000;
            bench.runUntil(to);
            const auto position = bench.of(1, 2).back();
            north[when].add((i32(position, 8) - 473'977'000) * kNorth_m);
            up[when].add(i32(position, 16) / 1000.0 - 488);
            if (when == 0) east.add((i32(position, 4) - 85'456'000) * east_m);
        }
        velocity.add(i32(bench.of(1, 0x12).back(), 8) / 100.0);
    }
    EXPECT_NEAR(north[0].deviation(), errors.gps_horizontal_m, 0.06);
    EXPECT_NEAR(north[1].deviation(), errors.gps_horizontal_m, 0.06);
    EXPECT_NEAR(east.deviation(), errors.gps_horizontal_m, 0.06);
    EXPECT_NEAR(up[0].deviation(), errors.gps_vertical_m, 0.15);
    EXPECT_NEAR(correlation(north[0], north[1]), std::exp(-1), 0.12);
    EXPECT_NEAR(correlation(up[0], up[1]), std::exp(-1), 0.12);
    EXPECT_NEAR(velocity.deviation(), errors.gps_velocity_mps, 0.005);
}
