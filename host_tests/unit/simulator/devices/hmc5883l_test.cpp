// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/hmc5883l.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "statistics.hpp"

using namespace simulator;

namespace {

struct Bench {
    explicit Bench(SensorErrors errors = SensorErrors::none(), uint64_t seed = 1,
                   CompassMount mount = {})
        : compass(seed, errors, mount) {}

    void write(uint8_t reg, uint8_t value) {
        EXPECT_TRUE(compass.start(false, now_us));
        compass.write(reg, now_us);
        compass.write(value, now_us);
        compass.stop(now_us);
    }
    std::vector<uint8_t> read(uint8_t reg, int size) {
        compass.start(false, now_us);
        compass.write(reg, now_us);
        compass.start(true, now_us);
        std::vector<uint8_t> out;
        for (int i = 0; i < size; ++i) out.push_back(compass.read(i + 1 < size, now_us));
        compass.stop(now_us);
        return out;
    }
    // In the chip's order: x, z, y.
    std::array<int16_t, 3> counts() {
        const auto bytes = read(3, 6);
        std::array<int16_t, 3> out;
        for (size_t i = 0; i < 3; ++i)
            out[i] = static_cast<int16_t>(bytes[2 * i] << 8 | bytes[2 * i + 1]);
        return out;
    }
    void continuous() {
        write(0, 0x78);
        write(1, 0x20);
        write(2, 0x00);
    }
    // As the drivers of this board turn them: negate x and z, then 90 degrees of yaw.
    std::array<double, 3> body_mg() {
        now_us += 13'400;
        const auto c = counts();
        const double x = -c[0] / 1.09, y = c[2] / 1.09, z = -c[1] / 1.09;
        return {-y, x, z};
    }

    Hmc5883l compass;
    uint64_t now_us = 1000;
};

}  // namespace

TEST(Hmc5883l, names_itself_and_keeps_what_is_written) {
    Bench bench;
    EXPECT_EQ(bench.read(10, 3), (std::vector<uint8_t>{'H', '4', '3'}));
    EXPECT_EQ(bench.read(0, 2), (std::vector<uint8_t>{0x10, 0x20}));
    bench.write(0, 0x78);
    EXPECT_EQ(bench.read(0, 1)[0], 0x78);
    bench.write(10, 0);
    EXPECT_EQ(bench.read(10, 1)[0], 'H');
}

TEST(Hmc5883l, writes_one_register_in_a_transfer) {
    Bench bench;
    bench.compass.start(false, bench.now_us);
    for (const uint8_t byte : {0, 0x78, 0x60, 0x00}) bench.compass.write(byte, bench.now_us);
    bench.compass.stop(bench.now_us);
    EXPECT_EQ(bench.read(0, 3), (std::vector<uint8_t>{0x78, 0x20, 0x02}));
}

TEST(Hmc5883l, gives_the_field_in_body_axes_after_the_documented_rotation) {
    Bench bench;
    bench.compass.sense({200, -100, 400});
    bench.continuous();
    const auto field = bench.body_mg();
    EXPECT_NEAR(field[0], 200, 1);
    EXPECT_NEAR(field[1], -100, 1);
    EXPECT_NEAR(field[2], 400, 1);
}

// An axis of the airplane as the turned chip's own axes see it, by hand.
TEST(Hmc5883l, sees_the_field_from_where_it_is_turned_to) {
    struct Row {
        double roll_deg, pitch_deg, yaw_deg;
        std::array<double, 3> seen_mg;
    };
    constexpr Row kRows[] = {{180, 0, 0, {200, 100, -400}}, {0, 180, 0, {-200, -100, -400}},
                             {0, 0, 90, {-100, -200, 400}},   // its x to the right
                             {90, 0, 0, {200, 400, 100}},     // its y down
                             {0, 90, 0, {-400, -100, 200}},   // its x up
                             {90, 0, 90, {-100, 400, 200}}};  // its x to the right, its y down
    for (const Row& row : kRows) {
        Bench bench(SensorErrors::none(), 1,
                    {CompassKind::hmc5883l, row.roll_deg, row.pitch_deg, row.yaw_deg});
        bench.compass.sense({200, -100, 400});
        bench.continuous();
        const auto seen = bench.body_mg();
        for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(seen[i], row.seen_mg[i], 1) << row.roll_deg;
    }
}

TEST(Hmc5883l, gives_x_then_z_then_y) {
    Bench bench;
    bench.compass.sense({-200, -100, -300});  // chip: x 100, y 200, z 300
    bench.continuous();
    bench.now_us += 14'000;
    EXPECT_EQ(bench.counts(), (std::array<int16_t, 3>{109, 327, 218}));
}

TEST(Hmc5883l, scales_by_its_gain_and_reports_an_overflow) {
    constexpr int16_t kCounts[8] = {685, 545, 410, 330, 220, 195, 165, 115};
    for (uint8_t gain = 0; gain < 8; ++gain) {
        Bench bench;
        bench.compass.sense({0, -500, -3000});
        bench.continuous();
        bench.write(1, static_cast<uint8_t>(gain << 5));
        bench.now_us += 14'000;
        const auto counts = bench.counts();
        EXPECT_EQ(counts[0], kCounts[gain]);
        EXPECT_EQ(counts[1], gain < 3 ? -4096 : kCounts[gain] * 6) << "beyond 2047 counts";
    }
}

TEST(Hmc5883l, measures_its_own_coil_in_self_test) {
    Bench bench;
    bench.compass.sense({200, -100, 400});
    bench.write(0, 0x11);
    bench.write(1, 0x60);
    bench.write(2, 0x01);
    bench.now_us += 50'000;
    EXPECT_EQ(bench.counts(), (std::array<int16_t, 3>{766, 713, 766}));
    bench.write(0, 0x12);
    bench.write(2, 0x01);
    bench.now_us += 50'000;
    EXPECT_EQ(bench.counts(), (std::array<int16_t, 3>{-766, -713, -766}));
}

TEST(Hmc5883l, measures_once_in_single_mode_and_rests) {
    Bench bench;
    bench.compass.sense({-100, -100, -100});
    bench.write(2, 0x01);
    bench.now_us += 5'900;
    EXPECT_EQ(bench.read(9, 1)[0] & 1, 0);
    bench.now_us += 200;
    EXPECT_EQ(bench.read(9, 1)[0] & 1, 1);
    EXPECT_EQ(bench.counts()[0], 109);
    bench.compass.sense({0, 0, 0});
    bench.now_us += 500'000;
    EXPECT_EQ(bench.counts()[0], 109);
    EXPECT_NE(bench.read(2, 1)[0] & 3, 1);
}

TEST(Hmc5883l, measures_at_its_rate_in_continuous_mode) {
    constexpr double kRate_hz[] = {0.75, 1.5, 3, 7.5, 15, 30, 75};
    for (uint8_t rate = 0; rate < 7; ++rate) {
        Bench bench;
        bench.write(0, static_cast<uint8_t>(rate << 2));
        bench.write(2, 0);
        int changes = 0;
        int16_t last = 0;
        for (int i = 0; i < 4000; ++i) {
            bench.now_us += 1000;
            bench.compass.sense({0, -i * 0.2, 0});
            const int16_t now = bench.counts()[0];
            if (now != last) ++changes;
            last = now;
        }
        EXPECT_NEAR(changes, 4 * kRate_hz[rate], 1.1);
    }
}

TEST(Hmc5883l, locks_its_data_until_all_of_it_is_read) {
    Bench bench;
    bench.compass.sense({-100, -100, -100});
    bench.continuous();
    bench.now_us += 14'000;
    bench.read(3, 2);
    EXPECT_EQ(bench.read(9, 1)[0] & 2, 2);
    bench.compass.sense({-200, -200, -200});
    bench.now_us += 14'000;
    EXPECT_EQ(bench.read(3, 2)[1], 109);
    bench.read(5, 4);
    EXPECT_EQ(bench.read(9, 1)[0] & 2, 0);
    bench.now_us += 14'000;
    EXPECT_EQ(bench.counts()[0], 218);
}

TEST(Hmc5883l, acknowledges_nothing_when_unplugged) {
    Bench bench;
    bench.compass.unplug(true);
    EXPECT_FALSE(bench.compass.start(false, 0));
    EXPECT_FALSE(bench.compass.write(0, 0));
}

TEST(Hmc5883l, errs_by_the_noise_and_offsets_of_the_table) {
    const SensorErrors errors;
    for (uint64_t seed = 1; seed <= 5; ++seed) {
        Bench bench(errors, seed);
        bench.compass.sense({200, -100, 400});
        bench.continuous();
        std::array<Statistics, 3> field;
        for (int i = 0; i < 4000; ++i) {
            const auto now = bench.body_mg();
            for (size_t axis = 0; axis < 3; ++axis) field[axis].add(now[axis]);
        }
        constexpr double kTruth[3] = {200, -100, 400};
        for (size_t axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(field[axis].deviation(), errors.compass_noise_mg, 0.1);
            EXPECT_NEAR(std::fabs(field[axis].mean() - kTruth[axis]), errors.compass_offset_mg, 1);
            EXPECT_NEAR(field[axis].mean() - kTruth[axis], bench.compass.offset_mg()[axis], 1);
        }
    }
}
