// SPDX-License-Identifier: GPL-3.0-or-later
// What each command's parameters may be. The answer is the one a ground station gets at upload; at
// run time any answer but 0 means that the record is skipped.
#include <math.h>

#include "core/seldom.hpp"
#include "firmware/mission/handlers.hpp"
#include "firmware/mission/mission.hpp"
#include "firmware/state/mode_traits.hpp"
#include "firmware/state/parameters.hpp"

namespace firmware {
namespace mission {

using namespace state;

namespace {

constexpr uint8_t kFine = 0;
constexpr uint8_t wrong(uint8_t parameter) { return static_cast<uint8_t>(5 + parameter); }
static_assert(wrong(1) == static_cast<uint8_t>(MissionResult::invalid_param1), "param1 is 6");

constexpr bool within(int32_t value, int32_t lowest, int32_t highest) {
    return value >= lowest && value <= highest;
}

constexpr int32_t kShortestPulse_us = 800, kLongestPulse_us = 2200;
constexpr int32_t kLongestCycle_s = 60;
constexpr int32_t kMaxRepeats = 32767;
constexpr int32_t kLongestDelay_s = 4000000;  // the millisecond clock goes round after 4,294,967 s

uint8_t pulse(int32_t value, uint8_t parameter) {
    return within(value, kShortestPulse_us, kLongestPulse_us) ? kFine : wrong(parameter);
}

SELDOM uint8_t airSpeed(int32_t speed_cms, uint8_t parameter) {
    return within(speed_cms, parameters.speed_min_mps * 100L, parameters.speed_max_mps * 100L)
               ? kFine
               : wrong(parameter);
}

uint8_t slotTakes(uint8_t slot, float value) {
    if (slot == kNoSlot) return wrong(1);
    if (parameterSlotTakes(slot, value)) return kFine;
    float present;
    return parameterGet(slot, present) ? wrong(2) : wrong(1);
}

}  // namespace

uint8_t anything(const Record&, ItemPosition) { return kFine; }

uint8_t placeInRange(const Record& record, ItemPosition) {
    if ((record.options & ::mission::kAboveTerrain) != 0)
        return static_cast<uint8_t>(MissionResult::unsupported_frame);
    if (!within(record.p3, -900000000, 900000000)) return wrong(5);
    return within(record.p4, -1800000000, 1800000000) ? kFine : wrong(6);
}

uint8_t takeoffInRange(const Record& record, ItemPosition position) {
    constexpr uint8_t kSteepest_deg = 60;
    if (record.p1 > kSteepest_deg) return wrong(1);
    Record without_place = record;
    without_place.p3 = without_place.p4 = 0;
    return placeInRange(without_place, position);
}

uint8_t delayInRange(const Record& record, ItemPosition) {
    return within(record.p3, 0, kLongestDelay_s) ? kFine : wrong(1);
}

uint8_t changeAltitudeInRange(const Record& record, ItemPosition) {
    constexpr int32_t kSlowest_cms = 11, kFastest_cms = 10000;
    if ((record.options & ::mission::kAboveTerrain) != 0)
        return static_cast<uint8_t>(MissionResult::unsupported_frame);
    return within(climbRate_cms(record), kSlowest_cms, kFastest_cms) ? kFine : wrong(1);
}

uint8_t distanceInRange(const Record& record, ItemPosition) {
    return record.p3 >= 0 ? kFine : wrong(1);
}

uint8_t jumpInRange(const Record& record, ItemPosition position) {
    if (record.p1 == 0 || record.p1 >= position.count || record.p1 == position.index)
        return wrong(1);
    return record.p3 == ::mission::kForEver || within(record.p3, 1, kMaxRepeats) ? kFine : wrong(2);
}

uint8_t changeSpeedInRange(const Record& record, ItemPosition) {
    constexpr int32_t kFastest_cms = 20000;
    if (record.p1 > 1) return wrong(1);
    if (!within(record.p3, -1, 100)) return wrong(3);
    if (record.p2 == -1) return kFine;
    if (record.p4 < 0 || !within(record.p2, 0, kFastest_cms / 100)) return wrong(2);
    const int32_t speed_cms = record.p4 != 0 ? record.p4 : record.p2 * 100;
    if (!within(speed_cms, 1, kFastest_cms)) return wrong(2);
    return record.p1 == 0 ? airSpeed(speed_cms, 2) : kFine;
}

uint8_t setHomeInRange(const Record& record, ItemPosition position) {
    if (record.p1 > 1) return wrong(1);
    return record.p1 == 1 ? kFine : placeInRange(record, position);
}

uint8_t setParameterInRange(const Record& record, ItemPosition) {
    const float value = parameterValue(record);
    return isfinite(value) ? slotTakes(record.p1, value) : wrong(2);
}

uint8_t setRelayInRange(const Record& record, ItemPosition) {
    if (record.p1 != 0) return wrong(1);  // the board has one
    return within(record.p2, 0, 1) ? kFine : wrong(2);
}

uint8_t repeatRelayInRange(const Record& record, ItemPosition) {
    if (record.p1 != 0) return wrong(1);
    if (!within(record.p2, 0, kMaxRepeats)) return wrong(2);
    return within(record.p3, 1, kLongestCycle_s) ? kFine : wrong(3);
}

uint8_t setServoInRange(const Record& record, ItemPosition) {
    if (!within(record.p1, 5, 8)) return wrong(1);
    return within(record.p2, 0, 1) ? kFine : pulse(record.p2, 2);
}

uint8_t repeatServoInRange(const Record& record, ItemPosition) {
    if (!within(record.p1, 5, 8)) return wrong(1);
    if (!within(record.p2, 0, kMaxRepeats)) return wrong(3);
    if (!within(record.p3, 1, kLongestCycle_s)) return wrong(4);
    return record.p4 == 0 ? kFine : pulse(record.p4, 2);
}

uint8_t continueInRange(const Record& record, ItemPosition position) {
    return record.p1 <= 2 ? placeInRange(record, position) : wrong(1);
}

uint8_t toHeightInRange(const Record& record, ItemPosition position) {
    return record.p1 <= 1 ? placeInRange(record, position) : wrong(1);
}

// https://mavlink.io/en/messages/common.html#MAV_ROI
uint8_t interestInRange(const Record& record, ItemPosition position) {
    constexpr uint8_t kTarget = 4;
    return record.p1 <= kTarget ? placeInRange(record, position) : wrong(1);
}

// https://mavlink.io/en/messages/common.html#MAV_MOUNT_MODE
uint8_t mountInRange(const Record& record, ItemPosition) {
    constexpr uint8_t kToHome = 6;
    if (!within(record.p2, -360, 360)) return wrong(1);
    if (!within(record.p3, -360, 360)) return wrong(2);
    if (!within(record.p4, -360, 360)) return wrong(3);
    return record.p1 <= kToHome ? kFine : wrong(7);
}

uint8_t triggerDistanceInRange(const Record& record, ItemPosition) {
    constexpr int32_t kFarthest_m = 10000;
    return within(record.p2, 0, kFarthest_m) && within(record.p3, 0, kFarthest_m * 100) ? kFine
                                                                                        : wrong(1);
}

// A series by time is nothing that we have.
uint8_t oneImageInRange(const Record& record, ItemPosition) {
    return record.p3 == 1 ? kFine : wrong(3);
}

uint8_t fenceInRange(const Record& record, ItemPosition) {
    return record.p1 <= 2 ? kFine : wrong(1);
}

uint8_t modeInRange(const Record& record, ItemPosition) {
    return isMode(record.p1) ? kFine : wrong(1);
}

uint8_t firstInRange(const Record&, ItemPosition position) {
    return position.count > 1 && position.index != 1 ? kFine
                                                     : static_cast<uint8_t>(MissionResult::invalid);
}

uint8_t indexInRange(const Record& record, ItemPosition position) {
    const int32_t target = record.p2 != 0 ? record.p2 : record.p1;
    return within(target, 1, position.count - 1) && target != position.index ? kFine : wrong(2);
}

uint8_t variableInRange(const Record& record, ItemPosition) {
    float value;
    return parameterGet(record.p1, value) ? kFine : wrong(1);
}

uint8_t onOffInRange(const Record& record, ItemPosition) {
    return record.p1 <= 1 ? kFine : wrong(1);
}

uint8_t cruiseSpeedInRange(const Record& record, ItemPosition) {
    return airSpeed(record.p1 * 100L, 1);
}

uint8_t cruiseThrottleInRange(const Record& record, ItemPosition) {
    return record.p1 <= 100 ? kFine : wrong(1);
}

uint8_t resetHomeInRange(const Record& record, ItemPosition position) {
    return placeInRange(record, position);
}

uint8_t gainInRange(const Record& record, ItemPosition) {
    return slotTakes(gainSlot(record.id, record.p1), gain(record));
}

uint8_t channelInRange(const Record& record, ItemPosition) {
    if (record.p1 > 7) return wrong(1);
    return pulse(record.p2, 2);
}

uint8_t otherRadioInRange(const Record& record, ItemPosition) {
    return slotTakes(otherRadioSlot(record.p1), static_cast<float>(record.p2));
}

uint8_t eventInRange(const Record& record, ItemPosition) {
    constexpr int32_t kLongestDelayed_s = 65535;
    if (record.p1 == 10) return kFine;
    if (record.p1 > 6) return wrong(1);
    const bool servo = within(record.p1, 1, 5);
    if (servo && !within(record.p2, kShortestPulse_us, kLongestPulse_us)) return wrong(2);
    if (!within(record.p3, 0, kLongestDelayed_s)) return wrong(3);
    return within(record.p4, 0, kMaxRepeats) ? kFine : wrong(4);
}

uint8_t pulseInRange(const Record& record, ItemPosition) {
    if (record.p1 > 7) return wrong(1);
    return within(record.p2, 0, 2000) ? kFine : wrong(2);
}

}  // namespace mission
}  // namespace firmware
