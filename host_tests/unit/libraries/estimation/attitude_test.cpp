// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/attitude.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "estimation/gyro_bias_init.hpp"
#include "flight.hpp"

namespace {

using estimation::Angles;
using estimation::Attitude;
using estimation::AttitudeSettings;
using flight::Errors;
using flight::Flight;

struct Figures {
    double roll = 0, pitch = 0, yaw = 0;  // squares summed, then RMS degrees
    double worst_roll = 0, worst_pitch = 0, worst_yaw = 0;
    int n = 0;

    void add(const Angles& a, const flight::Truth& t) {
        const double r = std::remainder(a.roll_rad.toFloat() - t.roll, 2 * M_PI) / flight::kDegree,
                     p = (a.pitch_rad.toFloat() - t.pitch) / flight::kDegree,
                     y = std::remainder(a.yaw_rad.toFloat() - t.yaw, 2 * M_PI) / flight::kDegree;
        roll += r * r;
        pitch += p * p;
        yaw += y * y;
        worst_roll = std::max(worst_roll, std::abs(r));
        worst_pitch = std::max(worst_pitch, std::abs(p));
        worst_yaw = std::max(worst_yaw, std::abs(y));
        ++n;
    }
    Figures rms() const {
        Figures f = *this;
        f.roll = sqrt(roll / n);
        f.pitch = sqrt(pitch / n);
        f.yaw = sqrt(yaw / n);
        return f;
    }
};

struct Sources {
    bool compass = true, gps = true, airspeed = false;
    double gps_lost_s = 1e9;  // from this time on
    double scored_s = 12;     // from this time on
    int fix_quarter = 3;      // of four frames, in which fixes come
    double wrong_s = 1e9;     // for two seconds from this time on fixes are wrong by ...
    double wrong_mps = 0;     // ... a random velocity
};

estimation::Motion motion(const core::Vector3& rate_rads, const core::Vector3& force_mss) {
    const auto turned = [](float rate) {
        return static_cast<int32_t>(rate * 0.01f * estimation::DeltaAngle::kSteps);
    };
    return {{{turned(rate_rads.x), turned(rate_rads.y), turned(rate_rads.z)}},
            core::BodyRates::from(rate_rads.x, rate_rads.y, rate_rads.z),
            core::Accelerations::from(force_mss.x, force_mss.y, force_mss.z),
            2};
}

// The estimator fed as the firmware feeds it: 100 Hz of pairs of samples, compass and GPS 5 Hz.
Figures fly(Flight& flight, const Sources& sources, Attitude& attitude) {
    AttitudeSettings settings;
    estimation::FixComparison seen;
    settings.use_compass = sources.compass;
    estimation::GyroBiasInit still;
    Figures figures;
    attitude.start();
    for (int frame = 0;; ++frame) {
        flight::V3 rate, force;
        for (int i = 0; i < 2; ++i) {
            if (!flight.step()) return figures;
            rate = rate + flight.gyro() * 0.5;
            force = force + flight.accel() * 0.5;
        }
        if (!still.done()) still.update(flight::single(rate), flight::single(force), 0.01f);
        if (!still.done()) continue;
        attitude.propagate(motion(flight::single(rate) - still.zero_rads(), flight::single(force)));
        if (frame % 10 == 2) attitude.align();
        if (frame % 2 == 0) attitude.rotateDcm();
        if (frame % 10 == 3) attitude.orthonormalize();
        if (frame % 10 == 6) attitude.pointYaw();
        if (frame % 4 == 1) attitude.accelerate();
        if (frame % 20 == 8 && sources.compass) {
            attitude.useCompass(flight::single(flight.compass()), settings);
        }
        const bool gps = sources.gps && flight.truth().time_s < sources.gps_lost_s;
        if (frame % 20 == 4 + sources.fix_quarter && gps) {
            flight::V3 velocity = flight.gps().velocity;
            const double wrong_for_s = flight.truth().time_s - sources.wrong_s;
            if (wrong_for_s > 0 && wrong_for_s < 2)
                for (double* part : {&velocity.x, &velocity.y})
                    *part += sources.wrong_mps * std::normal_distribution<>()(flight.random());
            attitude.useGps(flight::single(velocity), settings, seen);
        }
        if (frame % 20 == 4 + sources.fix_quarter && !gps) {
            attitude.useAirspeed(sources.airspeed ? static_cast<float>(flight.airspeed_mps()) : 0);
        }
        if (flight.truth().time_s > sources.scored_s)
            figures.add(attitude.angles(), flight.truth());
    }
}

Figures overSeeds(const Errors& errors, const Sources& sources, int seeds) {
    Figures sum;
    for (int seed = 1; seed <= seeds; ++seed) {
        Flight flight(flight::wholeFlight(), errors, seed, 37.0 * seed);
        Attitude attitude;
        attitude.start();
        const Figures f = fly(flight, sources, attitude);
        sum.roll += f.roll;
        sum.pitch += f.pitch;
        sum.yaw += f.yaw;
        sum.n += f.n;
        sum.worst_roll = std::max(sum.worst_roll, f.worst_roll);
        sum.worst_pitch = std::max(sum.worst_pitch, f.worst_pitch);
        sum.worst_yaw = std::max(sum.worst_yaw, f.worst_yaw);
    }
    return sum.rms();
}

TEST(Attitude, holds_a_fifth_of_a_degree_of_bank_over_whole_flights_with_every_error) {
    const Figures rms = overSeeds(Errors(), Sources(), 12);

    EXPECT_LT(rms.roll, 0.2);
    EXPECT_LT(rms.pitch, 0.25);
    EXPECT_LT(rms.yaw, 0.5);
}

// Fixes come when they do; four frames' forces are looked at together.
TEST(Attitude, compares_a_fix_with_its_own_time_whichever_frame_it_comes_in) {
    const Errors none = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0.243, 0, 0, 0, 0, 0, 0, 0};
    const std::vector<flight::Leg> circles = {{12, 0, 0, 0}, {26, 0, 8, 14}, {60, 45, 0, 14}};
    for (int quarter = 0; quarter < 4; ++quarter) {
        Flight flight(circles, none, 1);
        Attitude attitude;
        attitude.start();
        Sources sources;
        sources.fix_quarter = quarter;
        sources.scored_s = 50;
        const Figures rms = fly(flight, sources, attitude).rms();

        EXPECT_LT(rms.roll, 0.015) << quarter;
        EXPECT_LT(rms.pitch, 0.018) << quarter;
    }
}

// Its share of gravity turns with the airplane, the tilt does not.
TEST(Attitude, knows_the_accelerometers_bias_after_a_few_turns) {
    Errors errors;
    errors.accel_bias_g = 0.01;
    Sources sources;
    sources.scored_s = 180;
    const Figures rms = overSeeds(errors, sources, 12);

    EXPECT_LT(rms.roll, 0.25);
    EXPECT_LT(rms.pitch, 0.25);
}

// A fix that is older than assumed shows as acceleration along the path of every turn.
TEST(Attitude, does_not_take_other_errors_in_turns_for_accelerometer_bias) {
    Errors errors;
    errors.accel_bias_g = 0;
    errors.gps_age_s = 0.29;
    Sources sources;
    sources.scored_s = 180;
    const Figures rms = overSeeds(errors, sources, 12);

    EXPECT_LT(rms.roll, 0.3);
    EXPECT_LT(rms.pitch, 0.3);
}

TEST(Attitude, tolerates_a_fix_older_than_assumed) {
    Errors errors;
    errors.gps_age_s = 0.29;
    const Figures rms = overSeeds(errors, Sources(), 6);

    EXPECT_LT(rms.roll, 0.3);
    EXPECT_LT(rms.pitch, 0.3);
    EXPECT_LT(rms.yaw, 1.0);
}

// Until the receiver is known to be wrong; then its fixes are not used any more.
TEST(Attitude, stays_upright_while_fixes_are_wrong_for_two_seconds) {
    for (const double wrong_mps : {2.0, 5.0, 20.0, 100.0}) {
        Sources sources;
        sources.wrong_s = 180;
        sources.wrong_mps = wrong_mps;
        const Figures rms = overSeeds(Errors(), sources, 6);
        EXPECT_LT(rms.worst_roll, 6) << wrong_mps << " m/s";
        EXPECT_LT(rms.worst_pitch, 6) << wrong_mps << " m/s";
        EXPECT_LT(rms.worst_yaw, 12) << wrong_mps << " m/s";
    }
}

TEST(Attitude, corrects_compass_offsets_that_are_50_mG_wrong) {
    Errors errors;
    errors.compass_offset_mg = 50;
    Sources sources;
    sources.scored_s = 90;
    const Figures rms = overSeeds(errors, sources, 6);

    EXPECT_LT(rms.roll, 0.25);
    EXPECT_LT(rms.pitch, 0.45);
    EXPECT_LT(rms.yaw, 2.0);
}

TEST(Attitude, stays_upright_for_two_minutes_without_gps) {
    Sources sources;
    sources.gps_lost_s = 180;
    sources.airspeed = true;
    const Figures rms = overSeeds(Errors(), sources, 6);

    EXPECT_LT(rms.roll, 1.5);
    EXPECT_LT(rms.pitch, 1.5);
    EXPECT_LT(rms.worst_roll, 6);
}

TEST(Attitude, stays_upright_with_neither_gps_nor_airspeed) {
    Sources sources;
    sources.gps = false;
    const Figures rms = overSeeds(Errors(), sources, 6);

    EXPECT_LT(rms.roll, 10);
    EXPECT_LT(rms.pitch, 10);
}

TEST(Attitude, finds_its_heading_without_a_compass) {
    Sources sources;
    sources.compass = false;
    sources.scored_s = 40;
    const Figures rms = overSeeds(Errors(), sources, 6);

    EXPECT_LT(rms.roll, 0.5);
    EXPECT_LT(rms.pitch, 0.5);
    EXPECT_LT(rms.yaw, 3);
}

// Level, pointing where a compass shows it, and then resumed as if it had rolled meanwhile.
struct Resumed : testing::Test {
    Attitude attitude;
    core::Vector3 reading_mg = {150, 130, 430};

    float declination_rad = 0;

    void stand(double seconds, bool compass) {
        AttitudeSettings settings;
        settings.declination_rad = declination_rad;
        settings.use_compass = compass;
        for (int frame = 1; frame <= seconds * 100; ++frame) {
            attitude.propagate(motion({0, 0, 0}, {0, 0, -core::kGravity_mss}));
            if (frame % 10 == 0) attitude.align();
            if (frame % 2 == 0) attitude.rotateDcm();
            if (frame % 4 == 0) attitude.accelerate();
            if (frame % 10 == 0) attitude.orthonormalize();
            if (frame % 20 == 0) attitude.useCompass(reading_mg, settings);
        }
    }
    void resume(float rolled_rad) {
        estimation::SavedAttitude pose;
        estimation::SavedBiases learnt;
        stand(2, true);
        attitude.save(pose);
        attitude.save(learnt);
        attitude.resume(pose, learnt, {rolled_rad, 0, 0});
        ASSERT_NEAR(roll_rad(), rolled_rad, 0.05);
    }
    double roll_rad() const { return attitude.angles().roll_rad.toFloat(); }
};

// A compass is followed up to 45 degrees off.
struct Compared : Resumed {
    float shown(float off_rad) {
        const core::Vector3 field_mg = reading_mg;
        const float sine = sinf(off_rad), cosine = cosf(off_rad);
        reading_mg = {field_mg.x * cosine - field_mg.y * sine,
                      field_mg.x * sine + field_mg.y * cosine, field_mg.z};
        followed = attitude.useCompass(reading_mg, AttitudeSettings());
        reading_mg = field_mg;
        return attitude.compassTestRatio();
    }
    bool followed = false;
    estimation::FixComparison seen = {};
};

TEST_F(Compared, the_compass_is_off_by_a_share_of_what_is_followed) {
    attitude.start();
    EXPECT_EQ(attitude.compassTestRatio(), 0);
    stand(3, true);
    EXPECT_NEAR(attitude.compassTestRatio(), 0, 0.02);
    for (int fix = 0; fix < 600; ++fix) {  // two minutes, in which it settles
        stand(0.2, true);
        attitude.useGps({0, 0, 0}, AttitudeSettings(), seen);
    }
    for (const float off_deg : {-22.8f, 22.8f}) {
        EXPECT_NEAR(shown(core::radians(off_deg)), 0.5, 0.03);
        EXPECT_TRUE(followed);
        stand(60, true);  // the needle is back
    }
    EXPECT_GT(shown(core::radians(50)), 1);
    EXPECT_FALSE(followed);
    EXPECT_NEAR(shown(core::radians(180)), 2.58, 0.05);
}

struct Declined : Resumed {
    void standAt(float to_rad, double seconds) {
        declination_rad = to_rad;
        stand(seconds, true);
    }
    double yaw_rad() const { return std::atan2(attitude.noseEast(), attitude.noseNorth()); }
    double own_mg() const { return core::dot(attitude.compassOffset_mg(), {1, 1, 1}); }
};

// Half a minute after power-on the first fix comes, and with it the table's declination.
TEST_F(Declined, the_heading_turns_by_a_declination_that_becomes_known) {
    // of an inhabited place, and of 70 S, 77 E and the seas around the southern magnetic pole
    for (const float known_rad : {0.4f, -1.45f, 2.5f}) {
        attitude.start();
        standAt(0, 30);
        const double before_rad = yaw_rad(), own_before_mg = own_mg();
        standAt(known_rad, 0.6);
        EXPECT_NEAR(std::remainder(yaw_rad() - before_rad - known_rad, 2 * M_PI), 0, 0.05)
            << known_rad;
        standAt(known_rad, 30);
        EXPECT_NEAR(std::remainder(yaw_rad() - before_rad - known_rad, 2 * M_PI), 0, 0.005)
            << known_rad;
        EXPECT_NEAR(own_mg(), own_before_mg, 2) << "the compass is not off by it";
    }
}

// The heading of a record is the true one.
TEST_F(Declined, one_that_was_resumed_keeps_its_heading) {
    attitude.start();
    standAt(0.4f, 2);
    const double before_rad = yaw_rad();
    resume(0);
    stand(0.2, false);
    standAt(0.4f, 1);
    EXPECT_NEAR(yaw_rad(), before_rad, 0.02);
}

// The power was gone for a second, and who knows how it rolled meanwhile.
TEST_F(Resumed, finds_the_roll_by_the_field_before_a_fix_comes) {
    for (const float rolled_rad : {-0.9f, 0.9f}) {
        attitude.start();
        resume(rolled_rad);
        stand(1, true);
        EXPECT_NEAR(roll_rad(), 0, 0.25) << rolled_rad;  // a turn about the field is not seen
        EXPECT_NEAR(attitude.angles().pitch_rad.toFloat(), 0, 0.3) << rolled_rad;
    }
}

TEST_F(Resumed, learns_nothing_of_the_compass_meanwhile) {
    resume(0.9f);
    stand(1, true);
    EXPECT_EQ(attitude.compassOffset_mg().x, 0);
    EXPECT_EQ(attitude.compassOffset_mg().y, 0);
}

TEST_F(Resumed, keeps_its_roll_without_a_compass) {
    resume(0.9f);
    stand(1, false);
    EXPECT_NEAR(roll_rad(), 0.9, 0.05);
}

// On the ground, and after an inertial sensor that was started anew, the field is not known yet.
TEST_F(Resumed, an_attitude_found_anew_is_not_turned_by_the_field) {
    stand(2, true);
    reading_mg = {150, 430, 130};
    stand(1, true);
    EXPECT_NEAR(roll_rad(), 0, 0.02);
}

// In a hand, 15 degrees nose up, and from there pushed to 12 m/s within 0.4 s. Ten fixes a second.
TEST(AttitudeThrown, keeps_its_pitch_where_fixes_are_older_than_assumed) {
    constexpr float kPitch_rad = core::radians(15), kPush_mss = 30, kPush_s = 0.4f;
    const float sine = sinf(kPitch_rad), cosine = cosf(kPitch_rad);
    const core::Vector3 held_mss = {core::kGravity_mss * sine, 0, -core::kGravity_mss * cosine};
    const core::Vector3 field_mg = {210 * cosine - 430 * sine, 0, 210 * sine + 430 * cosine};
    for (const float age_s : {0.05f, 0.25f, 0.4f}) {
        Attitude attitude;
        estimation::FixComparison seen;
        for (int frame = 1; frame <= 900; ++frame) {
            const auto pushed_s = [](float time_s) {
                return core::limit(time_s - 5, 0.0f, kPush_s);
            };
            const float time_s = static_cast<float>(frame) * 0.01f;
            const bool pushed = time_s > 5 && time_s <= 5 + kPush_s;
            const core::Vector3 push_mss = {pushed ? kPush_mss : 0, 0, 0};
            attitude.propagate(motion({0, 0, 0}, held_mss + push_mss));
            if (frame % 10 == 0) attitude.align();
            if (frame % 2 == 0) attitude.rotateDcm();
            if (frame % 4 == 0) attitude.accelerate();
            if (frame % 10 == 0) attitude.orthonormalize();
            if (frame % 20 == 0) attitude.useCompass(field_mg, AttitudeSettings());
            const float fix_mps = kPush_mss * pushed_s(time_s - age_s);
            if (frame % 10 == 3)
                attitude.useGps({fix_mps * cosine, 0, -fix_mps * sine}, AttitudeSettings(), seen);
            const float pitch_rad = attitude.angles().pitch_rad.toFloat();
            if (time_s < 2) continue;
            ASSERT_NEAR(pitch_rad, kPitch_rad, core::radians(1)) << age_s << " at " << time_s;
        }
    }
}

}  // namespace
