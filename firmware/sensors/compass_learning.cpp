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

struct Turns {
    float stored_mg[3];    // offsets as they are stored
    float miss_mg;         // by how much a pair disagrees with the offsets, the mean of late
    int16_t anchor_mg[3];  // what readings are compared with
    int16_t low_mg[3], high_mg[3];
    uint8_t pairs;
};
struct Learning {
    Turns turns;
    uint8_t anchor_left;  // pairs; 0: there is none
    uint8_t axes_to_save;
};
core::FileState<Learning> learning{};

float field_mg() { return sqrtf(core::dot(vehicle.compass.field_mg, vehicle.compass.field_mg)); }

bool makesSense() {
    for (const float offset_mg : parameters.compass_offset_mg)
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
    parameters.compass_offset_mg[axis] = core::limit(offset_mg, -kMaxOffset_mg, kMaxOffset_mg);
}

// Along the difference of the two, by a part of the way.
float approach(const float (&apart_mg)[3], float half_squares, float square, float gain) {
    const float* const offset_mg = parameters.compass_offset_mg;
    float short_by = half_squares;
    for (uint8_t i = 0; i < 3; ++i) short_by -= apart_mg[i] * offset_mg[i];
    const float step = short_by / square * gain;
    for (uint8_t i = 0; i < 3; ++i) setOffset(i, offset_mg[i] + apart_mg[i] * step);
    return fabsf(short_by) / sqrtf(square);
}

void averageMiss(float miss_mg) {
    if (learning.turns.pairs == 0) learning.turns.miss_mg = miss_mg;
    learning.turns.miss_mg += (miss_mg - learning.turns.miss_mg) * 0.05f;
    if (learning.turns.pairs < kPairs) ++learning.turns.pairs;
}

bool offsetsMoved() {
    return memcmp(parameters.compass_offset_mg, learning.turns.stored_mg,
                  sizeof learning.turns.stored_mg) != 0;
}

}  // namespace

bool compassLearnsInFlight() {
    return parameters.compass_learn != 0 && vehicle.armed && vehicle.estimate.flying &&
           vehicle.compass.healthy;
}

void takeCompassOffset(core::Vector3& own_mg) {
    for (uint8_t i = 0; i < 3; ++i) setOffset(i, parameters.compass_offset_mg[i] - (&own_mg.x)[i]);
    own_mg = {0, 0, 0};
}

void addOffsetsNotStored(int16_t (&own_mg)[3]) {
    for (uint8_t i = 0; i < 3; ++i)
        own_mg[i] += static_cast<int16_t>(
            core::rounded(learning.turns.stored_mg[i] - parameters.compass_offset_mg[i]));
}

void noteStoredOffsets() {
    memcpy(learning.turns.stored_mg, parameters.compass_offset_mg, sizeof learning.turns.stored_mg);
}

void compassTurnsStart() {
    learning.anchor_left = 0;
    learning.turns = Turns();
    noteStoredOffsets();
    for (uint8_t i = 0; i < 3; ++i) {
        learning.turns.low_mg[i] = INT16_MAX;
        learning.turns.high_mg[i] = INT16_MIN;
    }
}

void restoreStoredOffsets() {
    memcpy(parameters.compass_offset_mg, learning.turns.stored_mg, sizeof learning.turns.stored_mg);
}

// Of the pairs wanted, and of having pointed each axis nearly all the way up and down the field.
uint8_t compassTurns_pct() {
    float least = static_cast<float>(learning.turns.pairs) / kPairs;
    const float wanted_mg = 1.2f * field_mg();
    for (uint8_t i = 0; i < 3; ++i) {
        const float way_mg =
            static_cast<float>(learning.turns.high_mg[i]) - learning.turns.low_mg[i];
        if (way_mg < least * wanted_mg) least = core::limit(way_mg / wanted_mg, 0.0f, 1.0f);
    }
    return static_cast<uint8_t>(least * 100);
}

float compassMiss_mg() { return learning.turns.miss_mg; }

bool compassFits(uint8_t within_mg) { return learning.turns.miss_mg < within_mg && makesSense(); }

void learnCompass(const core::Vector3& reading_mg) {
    const bool turned = vehicle.calibrating == Calibrating::compass;
    if (!turned && !compassLearnsInFlight()) {
        learning.anchor_left = 0;
        if (!vehicle.armed) noteStoredOffsets();
        return;
    }
    int16_t now_mg[3];
    float apart_mg[3];
    int32_t square = 0, squares = 0;
    for (uint8_t i = 0; i < 3; ++i) {
        now_mg[i] = static_cast<int16_t>(core::rounded((&reading_mg.x)[i]));
        const int16_t anchor = learning.turns.anchor_mg[i];
        const int16_t apart = now_mg[i] - anchor;
        square += core::product(apart, apart);
        squares += core::product(anchor, anchor) - core::product(now_mg[i], now_mg[i]);
        apart_mg[i] = apart;
    }
    if (turned) widen(now_mg);
    if (learning.anchor_left != 0) {
        if (square < kApart_mg * kApart_mg) return;
        const float gain = !turned ? 0.03f : learning.turns.pairs < kCoarse ? 0.4f : 0.12f;
        const float miss_mg = approach(apart_mg, 0.5f * static_cast<float>(squares),
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
        learning.axes_to_save = 3;
        return;
    }
    restoreStoredOffsets();
    sendStatusText(Severity::warning,
                   STATUS_TEXT("Compass offsets learnt make no sense: not stored"));
}

// One at a time: all three at once took 1.4 ms of the frame in which it was disarmed.
void storeLearntCompass() {
    if (learning.axes_to_save == 0) return;
    const uint8_t axis = --learning.axes_to_save;
    parameterSet(static_cast<uint8_t>(slot::compass_ofs_x + axis),
                 parameters.compass_offset_mg[axis]);
}

}  // namespace sensors
}  // namespace firmware
