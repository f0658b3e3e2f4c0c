// SPDX-License-Identifier: GPL-3.0-or-later
// Fence and rally points through the store they really lie in, and an airplane that follows them.
#pragma once
#include "firmware/gcs/mission_types.hpp"
#include "firmware/safety/failsafe.hpp"
#include "firmware/safety/fence.hpp"
#include "mission_rig.hpp"

namespace firmware {
using namespace safety;

constexpr geo::Position kHome = {470000000, 80000000};
constexpr int32_t kSide_e7 = 30000;  // the fence: 330 m north and south of home

inline geo::Position beside(int32_t north_e7, int32_t east_e7) {
    return {kHome.latitude_e7 + north_e7, kHome.longitude_e7 + east_e7};
}

inline MissionItem point(uint16_t command, const geo::Position& place, float param1 = 0,
                         float z = 0) {
    return {command, kRelativeFrame, param1, 0, 0, 0, place.latitude_e7, place.longitude_e7, z};
}

class Points : public Rig {
protected:
    static MissionResult store(uint8_t type, const Items& items) {
        const auto count = static_cast<uint16_t>(items.size());
        MissionResult result = whileBusy([&] { return uploadBegin(type, count); });
        for (uint16_t i = 0; i < count && result == MissionResult::accepted; ++i)
            result = whileBusy([&] { return uploadPut(type, i, items[i]); });
        return result == MissionResult::accepted ? whileBusy([&] { return uploadCommit(type); })
                                                 : result;
    }
    static void tenths(int count) {
        for (int i = 0; i < count; ++i) {
            runFence();
            runFailsafe();
            runMode();
            fakes::advance_ms(100);
        }
    }
};

}  // namespace firmware
