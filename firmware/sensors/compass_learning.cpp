// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/sensors/compass_learning.hpp"

#include <math.h>
#include <string.h>

#include "core/file_state.hpp"
#include "core/fixed.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/parameter_slots.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace sensors {

using namespace notify;
using namespace state;

namespace {

constexpr int32_t kApart_mg = 250;
constexpr uint8_t kPairsOfAnchor = 50;
constexpr uint8_t kPairs = 250;  // as many as are wanted
constexpr uint8_t kCoarse = 60;
constexpr float kMaxOffset_mg = 400;
// The share of what two readings differ by that is taken over in flight. The first flight has to
// find the offsets; later it would move right ones by what a motor and gusts add: 40 mG in one
// steep turn.
constexpr float kGainOfFirstFlight = 0.03f, kGainInFlight = 0.01f;
// Of what the estimator hands over at a time, which is a 150th of what a reading is off by: so much
// counts for the motor's part. Before the offsets are known, at the beginning of the first flight,
// a reading is off by far more than a motor adds.
constexpr float kMaxStep_mg = 20.0f / 150;
constexpr float kMaxMotor_mg = 200;

struct Turns {
    CompassCorrection stored;
    float miss_mg;         // by how much a pair disagrees with the offsets, the mean of late
    int16_t anchor_mg[3];  // what readings are compared with
    int16_t low_mg[3], high_mg[3];
    uint8_t pairs;
};
struct Learning {
    Turns turns;
    float mean_power;
    uint8_t anchor_left;  // pairs; 0: there is none
    uint8_t values_to_save;
};
core::FileState<Learning> learning{};

float field_mg() { return sqrtf(core::dot(vehicle.compass.field_mg, vehicle.compass.field_mg)); }

bool makesSense() {
    for (const float offset_mg : parameters.compass.offset_mg)
        if (fabsf(offset_mg) >= kMaxOffset_mg) return false;
    return field_mg() > 185 && field_mg() < 875;
}

void widen(const int16_t (&reading_mg)[3]) {
    for (uint8_t i = 0; i < 3; ++i) {
        if (reading_mg[i] < learning.turns.low_mg[i]) learning.turns.low_mg[i] = reading_mg[i];
        if (reading_mg[i] > learning.turns.high_mg[i]) learning.turns.high_mg[i] = reading_mg[i];
    }
}

void setOffset(uint8_t axis, float offset_mg) {
    parameters.compass.offset_mg[axis] = core::limit(offset_mg, -kMaxOffset_mg, kMaxOffset_mg);
}

// Along the difference of the two, by a part of the way.
float approach(const float (&apart_mg)[3], float half_squares, float square, float gain) {
    const float* const offset_mg = parameters.compass.offset_mg;
    float short_by = half_squares;
    for (uint8_t i = 0; i < 3; ++i) short_by -= apart_mg[i] * offset_mg[i];
    const float step = short_by / square * gain;
    for (uint8_t i = 0; i < 3; ++i) setOffset(i, offset_mg[i] + apart_mg[i] * step);
    return fabsf(short_by) / sqrtf(square);
}

void averageMiss(float miss_mg) {
    if (learning.turns.pairs == 0) learning.turns.miss_mg = miss_mg;
    learning.turns.miss_mg = core::lerp(learning.turns.miss_mg, miss_mg, 0.05f);
    if (learning.turns.pairs < kPairs) ++learning.turns.pairs;
}

// What a reading shows of the airplane itself, over how far the motor's power is above its mean, is
// what full throttle would add; a little of it is taken over at a time (normalised least mean
// squares, Widrow and Hoff 1960).
float motorShare(float above_mean) {
    constexpr float kShare = 0.01f * 150, kNoise = 0.09f;
    return kShare * above_mean / (kNoise + above_mean * above_mean);
}

// With no offset stored nobody has found them before.
float gainInFlight() {
    return core::isZero(learning.turns.stored.offset_mg[0]) ? kGainOfFirstFlight : kGainInFlight;
}

bool offsetsMoved() {
    return memcmp(&parameters.compass, &learning.turns.stored, sizeof learning.turns.stored) != 0;
}

}  // namespace

float motorPower() {
    if (!vehicle.armed) return 0;
    const int16_t throttle = vehicle.throttle_demand.raw;
    return core::Ratio::fromRaw(core::times14(throttle, throttle)).toFloat();
}

bool compassLearnsInFlight() {
    return parameters.compass_learn != 0 && vehicle.armed && vehicle.estimate.flying &&
           vehicle.compass.healthy;
}

void takeCompassOffset(core::Vector3& own_mg) {
    constexpr float kMean = 0.01f;  // in 20 s
    const float above_mean = motorPower() - learning.mean_power;
    learning.mean_power += above_mean * kMean;
    const float motor_share = motorShare(above_mean);
    for (uint8_t i = 0; i < 3; ++i) {
        float& own = (&own_mg.x)[i];
        setOffset(i, parameters.compass.offset_mg[i] - own);
        float& motor = parameters.compass.motor_mg[i];
        motor = core::limit(motor - core::limit(own, -kMaxStep_mg, kMaxStep_mg) * motor_share,
                            -kMaxMotor_mg, kMaxMotor_mg);
        own = 0;
    }
}

void addOffsetsNotStored(int16_t (&own_mg)[3]) {
    for (uint8_t i = 0; i < 3; ++i)
        own_mg[i] += static_cast<int16_t>(
            core::rounded(learning.turns.stored.offset_mg[i] - parameters.compass.offset_mg[i]));
}

void noteStoredOffsets() { learning.turns.stored = parameters.compass; }

void compassTurnsStart() {
    learning.anchor_left = 0;
    learning.turns = Turns();
    noteStoredOffsets();
    for (uint8_t i = 0; i < 3; ++i) {
        learning.turns.low_mg[i] = INT16_MAX;
        learning.turns.high_mg[i] = INT16_MIN;
    }
}

void restoreStoredOffsets() { parameters.compass = learning.turns.stored; }

// Of the pairs wanted, and of having pointed each axis nearly all the way up and down the field.
uint8_t compassTurns_pct() {
    float least = core::real(learning.turns.pairs) / kPairs;
    const float wanted_mg = 1.2f * field_mg();
    for (uint8_t i = 0; i < 3; ++i) {
        const float way_mg =
            core::real(learning.turns.high_mg[i]) - core::real(learning.turns.low_mg[i]);
        if (way_mg < least * wanted_mg) least = core::limit(way_mg / wanted_mg, 0.0f, 1.0f);
    }
    return static_cast<uint8_t>(least * 100);
}

float compassMiss_mg() { return learning.turns.miss_mg; }

bool compassFits(uint8_t within_mg) {
    return learning.turns.miss_mg < core::real(within_mg) && makesSense();
}

void learnCompass(const int16_t (&now_mg)[3]) {
    const bool turned = vehicle.calibrating == Calibrating::compass;
    if (!turned && !compassLearnsInFlight()) {
        learning.anchor_left = 0;
        if (!vehicle.armed) noteStoredOffsets();
        return;
    }
    float apart_mg[3];
    int32_t square = 0, squares = 0;
    for (uint8_t i = 0; i < 3; ++i) {
        const int16_t anchor = learning.turns.anchor_mg[i];
        const int16_t apart = now_mg[i] - anchor;
        square += core::product(apart, apart);
        squares += core::product(anchor, anchor) - core::product(now_mg[i], now_mg[i]);
        apart_mg[i] = core::real(apart);
    }
    if (turned) widen(now_mg);
    if (learning.anchor_left != 0) {
        if (square < kApart_mg * kApart_mg) return;
        const float gain = !turned ? gainInFlight() : learning.turns.pairs < kCoarse ? 0.4f : 0.12f;
        const float miss_mg = approach(apart_mg, core::half(static_cast<float>(squares)),
                                       static_cast<float>(square), gain);
        if (turned) averageMiss(miss_mg);
        if (--learning.anchor_left != 0) return;
    }
    learning.anchor_left = kPairsOfAnchor;
    for (uint8_t i = 0; i < 3; ++i) learning.turns.anchor_mg[i] = now_mg[i];
}

void saveLearntCompass() {
    if (parameters.compass_learn == 0 || !offsetsMoved()) return;
    if (vehicle.compass.healthy && makesSense()) {
        learning.values_to_save = 6;
        return;
    }
    restoreStoredOffsets();
    sendStatusText(Severity::warning,
                   STATUS_TEXT("Compass offsets learnt make no sense: not stored"));
}

// One at a time: all three offsets at once took 1.4 ms of the frame in which it was disarmed.
void storeLearntCompass() {
    if (learning.values_to_save == 0) return;
    const uint8_t value = --learning.values_to_save;
    const bool motor = value >= 3;
    const uint8_t axis = motor ? value - 3 : value;
    const uint8_t first = motor ? slot::compass_mot_x : slot::compass_ofs_x;
    parameterSet(static_cast<uint8_t>(first + axis),
                 motor ? parameters.compass.motor_mg[axis] : parameters.compass.offset_mg[axis]);
}

}  // namespace sensors
}  // namespace firmware
