// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/state/restart_record.hpp"

#include <stddef.h>

#include "core/crc.hpp"

namespace firmware {
namespace state {

namespace {

constexpr uint16_t kLayout = 0x5202;  // another one when a record changes

constexpr float kFlyingSpeed_mps = 5.0f;
constexpr float kFlyingHeight_m = 5.0f;  // the barometer's drift is less

template <class Record>
uint16_t sum(const Record& record) {
    return core::crc16(kLayout, &record, offsetof(Record, seal));
}

}  // namespace

void seal(BlindRecord& blind, const MovingRecord& after) {
    blind.seal = core::crc16(after.seal, &blind.turn, sizeof blind.turn);
}
bool whole(const BlindRecord& blind, const MovingRecord& after) {
    return blind.seal == core::crc16(after.seal, &blind.turn, sizeof blind.turn);
}

void seal(SteadyRecord& record) { record.seal = sum(record); }
void seal(MovingRecord& record) { record.seal = sum(record); }
bool whole(const SteadyRecord& record) { return record.seal == sum(record); }
bool whole(const MovingRecord& record) { return record.seal == sum(record); }
void spoil(SteadyRecord& record) { record.seal = static_cast<uint16_t>(~sum(record)); }
void spoil(MovingRecord& record) { record.seal = static_cast<uint16_t>(~sum(record)); }

const MovingRecord* newest(const MovingRecord (&two)[2]) {
    const bool first = whole(two[0]), second = whole(two[1]);
    if (!first && !second) return nullptr;
    if (!second) return &two[0];
    if (!first) return &two[1];
    return static_cast<int8_t>(two[1].number - two[0].number) > 0 ? &two[1] : &two[0];
}

bool inTheAir(const FlightSigns& signs) {
    const bool moves = signs.ground_speed_mps > kFlyingSpeed_mps;
    const bool high = signs.height_m > kFlyingHeight_m || signs.height_m < -kFlyingHeight_m;
    return signs.armed && signs.flying && (moves || high);
}

float lost_s(uint16_t record_ms, uint16_t ended_ms, uint16_t since_ms) {
    constexpr uint16_t kMax_ms = 1000;
    const uint16_t before_ms = ended_ms - record_ms;
    const uint32_t all_ms = uint32_t{before_ms} + since_ms;
    return all_ms < kMax_ms ? static_cast<float>(all_ms) * 0.001f : kMax_ms * 0.001f;
}

}  // namespace state
}  // namespace firmware
