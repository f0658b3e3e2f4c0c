// SPDX-License-Identifier: GPL-3.0-or-later
// The rest of the flight program as telemetry sees it: does what the test says and remembers
// what it was asked to do.
#pragma once
#include <stdint.h>

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "drivers/gps_fix.hpp"
#include "firmware/mission/lists.hpp"
#include "firmware/mission/mission.hpp"
#include "firmware/modes/modes.hpp"
#include "firmware/safety/arming.hpp"
#include "geo/position.hpp"

namespace doubles {

struct Mission {
    uint16_t triggers = 0;
    bool radio_off = false;
    std::vector<firmware::mission::MissionItem> items;
    std::vector<firmware::mission::MissionItem> staged;
    bool uploading = false;
    uint16_t first = 0;
    uint16_t room = 170;
    int busy = 0;  // so many more calls are answered with busy
    uint16_t current = 0;
    uint32_t id = 0;  // listId
    bool complete = false;
    std::vector<uint16_t> reached;
    std::optional<uint16_t> unsupported;  // a command the vehicle does not know
    int aborts = 0;
    int restarts = 0;
    bool land_start = false, landing = false;  // there is one to go to; one is flown
    int landings = 0;
    std::vector<float> around_m;
    std::vector<firmware::mission::MissionItem> acts;  // ordered from the ground
    firmware::mission::MissionResult answer =
        firmware::mission::MissionResult::accepted;  // to every order
};
extern core::FileState<Mission> plan;

// The fence and the rally points, as records.
struct Lists {
    using Record = std::vector<uint8_t>;
    std::vector<Record> now[3], staged;
    uint8_t generation[3] = {};
    firmware::mission::ListKind kind = firmware::mission::ListKind::mission;  // of what is staged
    uint8_t count = 0;
    bool staging = false;
    int slow = 0;  // so many more puts are answered with busy
};
extern core::FileState<Lists> lists;

struct Vehicle {
    std::vector<std::pair<firmware::state::Mode, firmware::modes::ModeReason>> modes;  // asked for
    bool mode_can_be_entered = true;
    bool can_arm = true;
    bool force = false;  // of the last arm or disarm
    bool home_can_be_set = true;
    std::optional<geo::Position> home;
    int32_t home_altitude_cm = 0;
    std::vector<firmware::mission::MissionItem> targets, heights;  // of GUIDED
    int switch_resets = 0;
    std::vector<float> courses_rad;
    std::vector<firmware::mission::MissionItem> takeoffs;
    core::Vector3 rest_force_mss = {0, 0, -core::kGravity_mss};
    bool wrong_board = false;
    drivers::GpsFix fix = {};
    uint16_t vibration_cmss[3] = {};
    uint8_t clips = 0;
    int gyro_calibrations = 0;
    int pressure_calibrations = 0;
};
extern core::FileState<Vehicle> vehicle;

}  // namespace doubles
