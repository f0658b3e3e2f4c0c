// SPDX-License-Identifier: GPL-3.0-or-later
// The firmware's mission on the doubles: an airplane that stands where the test puts it, a ground
// station that uploads, and the texts it receives.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "fakes/fakes.hpp"
#include "firmware/actuators/camera.hpp"
#include "firmware/actuators/flaps.hpp"
#include "firmware/actuators/outputs.hpp"
#include "firmware/actuators/relay.hpp"
#include "firmware/control/inverted.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/mission/command_table.hpp"
#include "firmware/mission/engine.hpp"
#include "firmware/mission/handlers.hpp"
#include "firmware/mission/item.hpp"
#include "firmware/mission/mission.hpp"
#include "firmware/mission/servo_relay_events.hpp"
#include "firmware/modes/modes.hpp"
#include "firmware/notify/text_queue.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"
#include "host_tests/support/fakes/vehicle.hpp"

namespace firmware {
using namespace notify;
using namespace state;
using namespace actuators;
using namespace mission;
using namespace modes;
using namespace gcs;

constexpr uint8_t kGlobalFrame = 0, kMissionFrame = 2, kRelativeFrame = 3;

namespace mission {
inline bool operator==(const MissionItem& a, const MissionItem& b) {
    return a.command == b.command && a.frame == b.frame && a.param1 == b.param1 &&
           a.param2 == b.param2 && a.param3 == b.param3 && a.param4 == b.param4 && a.x == b.x &&
           a.y == b.y && a.z == b.z;
}
}  // namespace mission
inline void PrintTo(const MissionItem& item, std::ostream* os) {
    *os << item.command << " frame " << int(item.frame) << " (" << item.param1 << ", "
        << item.param2 << ", " << item.param3 << ", " << item.param4 << ") " << item.x << " "
        << item.y << " " << item.z;
}
inline void PrintTo(MissionResult result, std::ostream* os) { *os << int(result); }
inline void PrintTo(Mode mode, std::ostream* os) { *os << "mode " << int(mode); }

using Items = std::vector<MissionItem>;

inline MissionItem placed(uint16_t command, int32_t north_m, int32_t east_m, float z,
                          float param1 = 0, float param2 = 0) {
    return {command,
            kRelativeFrame,
            param1,
            param2,
            0,
            0,
            470000000 + north_m * 90,
            80000000 + east_m * 132,
            z};
}
inline MissionItem waypoint(int32_t north_m, float z = 50) { return placed(16, north_m, 0, z); }
inline MissionItem takeoff(float z = 50) { return {22, kRelativeFrame, 12, 0, 0, 0, 0, 0, z}; }
inline MissionItem command(uint16_t id, float p1 = 0, float p2 = 0, float p3 = 0, float p4 = 0) {
    return {id, kMissionFrame, p1, p2, p3, p4, 0, 0, 0};
}

// Of the parameter; "": there is none in the slot.
inline std::string nameOfSlot(uint8_t slot) {
    uint16_t row;
    char name[16];
    float value;
    uint8_t type;
    if (slot == kNoSlot || !parameterOfSlot(slot, row) || !parameterAt(row, name, value, type))
        return "";
    return {name, strnlen(name, sizeof name)};
}

class Rig : public testing::Test {
protected:
    void SetUp() override {
        while (parametersLoad() == core::Status::busy) {
        }
        startOutputs();
        mutable_vehicle.estimate.position = {470000000, 80000000};
        mutable_vehicle.estimate.known = true;
        mutable_vehicle.gps.fix = GpsFix::three_d;
        mutable_vehicle.gps.position = vehicle.estimate.position;
        mutable_vehicle.home.position = vehicle.estimate.position;
        mutable_vehicle.home.altitude_cm = 40000;
        mutable_vehicle.home.set = true;
        mutable_vehicle.armed = true;
        mutable_vehicle.imu.healthy = mutable_vehicle.attitude.aligned = true;
        mutable_vehicle.estimate.flying = true;
        mutable_vehicle.estimate.height_m = 50;
        missionBoot();
        requestMode(Mode::loiter, ModeReason::boot);
        runOutputs();
    }

    // All status texts since the last call.
    static std::string statusTexts() {
        std::vector<uint8_t>& out = fakes::serial(hal::Port::link0).out;
        out.clear();
        while (textWaits(links[0]) && sendText(links[0])) {
        }
        while (textWaits(links[1]) && sendText(links[1])) {
        }
        std::string text;
        for (uint8_t byte : out) text += byte >= 32 && byte < 127 ? static_cast<char>(byte) : '|';
        out.clear();
        return text;
    }
    static bool hasStatusText(const std::string& part) {
        return statusTexts().find(part) != std::string::npos;
    }

    template <class Call>
    static MissionResult whileBusy(Call call) {
        for (int i = 0; i < 3000; ++i) {
            const MissionResult result = call();
            if (result != MissionResult::busy) return result;
            missionRun();
            fakes::advance_ms(20);
        }
        return MissionResult::busy;
    }
    static MissionResult uploadFrom(uint16_t first, const Items& items) {
        for (size_t i = 0; i < items.size(); ++i) {
            const uint16_t index = static_cast<uint16_t>(first + i);
            const MissionResult result =
                whileBusy([&] { return missionUploadItem(index, items[i]); });
            if (result != MissionResult::accepted) return result;
        }
        return whileBusy(missionCommit);
    }
    static MissionResult uploadRaw(const Items& items) {
        const MissionResult begun =
            whileBusy([&] { return missionBeginUpload(static_cast<uint16_t>(items.size())); });
        return begun == MissionResult::accepted ? uploadFrom(0, items) : begun;
    }
    // Home is added.
    static MissionResult upload(Items items) {
        items.insert(items.begin(),
                     parameters.mission_set == 1 ? placed(16, 0, 0, 0) : placed(16, 0, 0, 0));
        return uploadRaw(items);
    }
    static MissionResult uploadPartial(uint16_t first, const Items& items) {
        const uint16_t last = static_cast<uint16_t>(first + items.size() - 1);
        const MissionResult begun = whileBusy([&] { return missionBeginPartial(first, last); });
        return begun == MissionResult::accepted ? uploadFrom(first, items) : begun;
    }
    static MissionItem stored(uint16_t index) {
        MissionItem item = {};
        EXPECT_EQ(missionItem(index, item), core::Status::ok);
        return item;
    }
    // What comes back of an item that went up as number 1.
    static MissionItem roundTrip(const MissionItem& item) {
        EXPECT_EQ(upload({item, waypoint(100), waypoint(200)}), MissionResult::accepted);
        return stored(1);
    }
    static MissionResult answer(const MissionItem& item) {
        const MissionResult result = upload({item, waypoint(100), waypoint(200)});
        missionAbort();
        return result;
    }

    static bool enterAuto() {
        const bool entered = requestMode(Mode::automatic, ModeReason::ground);
        pass();
        return entered;
    }
    static void fly(const Items& items) {
        ASSERT_EQ(upload(items), MissionResult::accepted);
        ASSERT_TRUE(enterAuto());
    }
    // What an upload would have refused may still come with a flashed image.
    static void storeImage(uint8_t set, const std::vector<::mission::Record>& records) {
        ASSERT_EQ(mission_store.begin(uint8_t(records.size()), set), core::Status::ok);
        for (const auto& record : records) {
            uint8_t bytes[::mission::kRecordSize];
            ::mission::pack(static_cast<::mission::Set>(set), record, bytes);
            ASSERT_EQ(mission_store.put(bytes), core::Status::ok);
        }
        core::Status status;
        while ((status = mission_store.commit()) == core::Status::busy) {
        }
        ASSERT_EQ(status, core::Status::ok);
        missionBoot();
    }
    // A tenth of a second; guidance has seen the new path and is far from its end.
    static void pass(int times = 1) {
        for (int i = 0; i < times; ++i) {
            runOutputs();
            missionRun();
            fakes::advance_ms(20);  // as in the task table
            missionCatchUp();
            reportVariables();
            runCamera();
            runFlaps();
            control::runInverted();
            runEvents();
            if (vehicle.demand.new_path) {
                mutable_vehicle.demand.new_path = false;
                mutable_vehicle.progress = {};
                mutable_vehicle.progress.distance_m = 5000;
            }
            runOutputs();
            fakes::advance_ms(80);
        }
    }
    static void seconds(int count) { pass(count * 10); }
    static void reach() {
        mutable_vehicle.progress.distance_m = 0;
        pass();
    }
};

}  // namespace firmware
