// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/actuators/flaps.hpp"

#include "firmware/actuators/outputs.hpp"
#include "firmware/guidance/guidance.hpp"
#include "firmware_bench.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace {

using firmware::actuators::outputPulse_us;
using firmware::state::Mode;
using firmware::state::mutable_vehicle;
using firmware::state::parameters;

constexpr int kFlap = 5, kAutoFlap = 6, kLever = 7;  // outputs, and the lever's channel

class Flaps : public bench::Bench {
protected:
    void SetUp() override {
        Bench::SetUp();
        parameters.output_function[kFlap - 5] = firmware::actuators::kFlapFunction;
        parameters.output_function[kAutoFlap - 5] = firmware::actuators::kAutoFlapFunction;
        parameters.flap_channel = kLever;
        parameters.flap_slew_pct = 0;
        firmware::actuators::startOutputs();
        mutable_vehicle.attitude.cos_roll = mutable_vehicle.attitude.cos_pitch = core::Ratio(1);
        mutable_vehicle.airspeed.healthy = true;
        moveLever(1100);
    }
    void moveLever(uint16_t pulse_us) {
        settle(with(kLever, pulse_us));
        tenths(1);
    }
    // Tenths of a second at a demanded airspeed.
    void tenths(int count, float airspeed_mps = 13) {
        for (int i = 0; i < count; ++i) {
            firmware::modes::runMode();
            mutable_vehicle.demand.airspeed_mps = airspeed_mps;
            firmware::guidance::runGuidance();
            firmware::actuators::runFlaps();
            firmware::actuators::runOutputs();
        }
    }
    // 50 % from 12 m/s on and 100 % from 10 m/s on.
    void stagesInLoiter() {
        parameters.flap[0] = {50, 12};
        parameters.flap[1] = {100, 10};
        fly(Mode::loiter);
        tenths(2);
    }
};

TEST_F(Flaps, follow_the_lever_from_its_shortest_pulse_to_its_longest) {
    const std::pair<uint16_t, int> cases[] = {
        {1000, 1100}, {1100, 1100}, {1300, 1300}, {1900, 1900}, {2000, 1900}};
    for (const auto& [lever_us, flap_us] : cases) {
        moveLever(lever_us);
        EXPECT_NEAR(outputPulse_us(kFlap), flap_us, 1) << lever_us;
        EXPECT_NEAR(outputPulse_us(kAutoFlap), flap_us, 1) << lever_us;
    }
}

TEST_F(Flaps, turn_round_with_their_output_but_not_with_the_lever) {
    parameters.channel[kFlap - 1].reverse = -1;
    parameters.channel[kLever - 1].reverse = -1;
    moveLever(1300);
    EXPECT_NEAR(outputPulse_us(kFlap), 1700, 1);
    EXPECT_NEAR(outputPulse_us(kAutoFlap), 1300, 1);
}

TEST_F(Flaps, stay_retracted_without_a_channel) {
    parameters.flap_channel = 0;
    moveLever(1900);
    EXPECT_EQ(outputPulse_us(kFlap), 1100);
}

TEST_F(Flaps, stay_where_they_were_when_the_radio_is_lost) {
    moveLever(1500);
    loseRadio(3000);
    tenths(5);
    EXPECT_NEAR(outputPulse_us(kFlap), 1500, 1);
}

TEST_F(Flaps, move_no_faster_than_the_slew_rate) {
    parameters.flap_slew_pct = 50;
    settle(with(kLever, 1900));
    tenths(10);
    EXPECT_NEAR(outputPulse_us(kFlap), 1500, 8) << "half in a second";
    tenths(11);
    EXPECT_EQ(outputPulse_us(kFlap), 1900);
    settle(with(kLever, 1100));
    tenths(10);
    EXPECT_NEAR(outputPulse_us(kFlap), 1500, 8);
}

TEST_F(Flaps, go_out_by_themselves_at_the_airspeed_of_each_stage) {
    stagesInLoiter();
    EXPECT_EQ(outputPulse_us(kAutoFlap), 1100);
    tenths(1, 12);
    EXPECT_NEAR(outputPulse_us(kAutoFlap), 1500, 2);
    EXPECT_EQ(outputPulse_us(kFlap), 1100) << "the lever's alone";
    tenths(1, 10);
    EXPECT_NEAR(outputPulse_us(kAutoFlap), 1900, 2);
    tenths(1, 13);
    EXPECT_EQ(outputPulse_us(kAutoFlap), 1100);
}

TEST_F(Flaps, do_not_flutter_at_the_speed_of_a_stage) {
    stagesInLoiter();
    tenths(1, 12);
    tenths(1, 12.4f);
    EXPECT_NEAR(outputPulse_us(kAutoFlap), 1500, 2);
    tenths(1, 12.6f);
    EXPECT_EQ(outputPulse_us(kAutoFlap), 1100);
}

TEST_F(Flaps, are_as_far_out_as_the_lever_asks_where_that_is_more) {
    stagesInLoiter();
    moveLever(1700);
    tenths(1, 12);
    EXPECT_NEAR(outputPulse_us(kAutoFlap), 1700, 2);
    moveLever(1200);
    tenths(1, 12);
    EXPECT_NEAR(outputPulse_us(kAutoFlap), 1500, 2);
}

TEST_F(Flaps, do_not_move_by_themselves_while_the_pilot_has_the_throttle) {
    stagesInLoiter();
    tenths(1, 10);
    for (Mode mode : {Mode::manual, Mode::fbwa}) {
        fly(mode);
        tenths(1, 10);
        EXPECT_EQ(outputPulse_us(kAutoFlap), 1100) << static_cast<int>(mode);
    }
}

TEST_F(Flaps, go_out_for_a_landing_whatever_the_airspeed) {
    parameters.land_flap_pct = 60;
    stagesInLoiter();
    mutable_vehicle.demand.path = firmware::state::Path::land;
    tenths(1, 13);
    EXPECT_NEAR(outputPulse_us(kAutoFlap), 1580, 2);
    tenths(1, 10);
    EXPECT_NEAR(outputPulse_us(kAutoFlap), 1580, 2);
    mutable_vehicle.demand.path = firmware::state::Path::leg;
    tenths(1, 13);
    EXPECT_EQ(outputPulse_us(kAutoFlap), 1100) << "it goes around";
    parameters.land_flap_pct = 0;
    mutable_vehicle.demand.path = firmware::state::Path::land;
    tenths(1, 12);
    EXPECT_GT(outputPulse_us(kAutoFlap), 1490) << "by the speed";
}

TEST_F(Flaps, have_no_stage_with_a_speed_of_zero) {
    stagesInLoiter();
    parameters.flap[1].speed_mps = 0;
    tenths(1, 9);
    EXPECT_NEAR(outputPulse_us(kAutoFlap), 1500, 2);
}

}  // namespace
