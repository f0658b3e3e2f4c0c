// SPDX-License-Identifier: GPL-3.0-or-later
// ARSPD_RATIO as it is learnt in flight.
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware_bench.hpp"
#include "storage/owner.hpp"

namespace {

using namespace firmware::state;
using firmware::sensors::learnAirspeedRatio;
using firmware::sensors::saveAirspeedRatio;

class AirspeedRatio : public bench::Bench {
protected:
    void SetUp() override {
        Bench::SetUp();
        while (storage::claim() == core::Status::busy) fakes::advance_ms(10);
        load();
    }
    static void load() {
        while (parametersLoad() != core::Status::ok) fakes::advance_ms(10);
    }
    static void store() {
        for (int i = 0; i < 100; ++i) {
            parametersRun();
            fakes::advance_ms(10);
        }
    }
};

TEST_F(AirspeedRatio, grows_by_twice_the_share_of_the_speed_that_is_missing_within_350_s) {
    for (int i = 0; i < 5; ++i) learnAirspeedRatio(0.05f, 0.2f);
    EXPECT_NEAR(parameters.airspeed_ratio, 1.9936f * (1 + 2 * 0.05f * 1 / 350), 1e-4f);
}

TEST_F(AirspeedRatio, stays_within_a_fifth_of_a_usual_sensors) {
    for (int i = 0; i < 1000; ++i) learnAirspeedRatio(0.3f, 1);
    EXPECT_FLOAT_EQ(parameters.airspeed_ratio, 2.4f);
    for (int i = 0; i < 1000; ++i) learnAirspeedRatio(-0.3f, 1);
    EXPECT_FLOAT_EQ(parameters.airspeed_ratio, 1.6f);
}

TEST_F(AirspeedRatio, is_left_alone_where_it_is_another_sensors_or_not_to_be_learnt) {
    parameters.airspeed_ratio = 3;
    learnAirspeedRatio(0.1f, 1);
    EXPECT_FLOAT_EQ(parameters.airspeed_ratio, 3);
    parameters.airspeed_ratio = 2;
    parameters.airspeed_autocal = 0;
    learnAirspeedRatio(0.1f, 1);
    EXPECT_FLOAT_EQ(parameters.airspeed_ratio, 2);
}

TEST_F(AirspeedRatio, is_stored_once_it_was_learnt) {
    parameters.airspeed_ratio = 1.9f;  // nobody has learnt that
    saveAirspeedRatio();
    store();
    load();
    EXPECT_FLOAT_EQ(parameters.airspeed_ratio, 1.9936f);

    for (int i = 0; i < 350; ++i) learnAirspeedRatio(0.05f, 1);
    const float learnt = parameters.airspeed_ratio;
    EXPECT_GT(learnt, 2.1f);
    saveAirspeedRatio();
    store();
    parameters.airspeed_ratio = 1;
    load();
    EXPECT_FLOAT_EQ(parameters.airspeed_ratio, learnt);
}

}  // namespace
