// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/mission_upload.hpp"

#include <array>
#include <cmath>

namespace simulator {

using namespace mavlink;

constexpr uint64_t kAnnounceAgain_us = 1'500'000;
constexpr int kAnnouncements = 10;
constexpr uint64_t kSilence_us = 10'000'000;  // without a further request: the vehicle gave up

static std::string resultName(uint8_t result) {
    static constexpr std::array<const char*, 16> kNames = {"accepted",
                                                           "error",
                                                           "unsupported frame",
                                                           "unsupported command",
                                                           "no space",
                                                           "invalid",
                                                           "invalid param 1",
                                                           "invalid param 2",
                                                           "invalid param 3",
                                                           "invalid param 4",
                                                           "invalid x",
                                                           "invalid y",
                                                           "invalid z",
                                                           "invalid sequence",
                                                           "denied",
                                                           "cancelled"};
    return result < kNames.size() ? kNames[result] : "result " + std::to_string(result);
}

std::string MissionUpload::name() const {
    return type_ == UploadOf::fence   ? "fence"
           : type_ == UploadOf::rally ? "rally points"
                                      : "mission";
}

void MissionUpload::step(uint64_t now_us, uint8_t system, uint8_t component) {
    system_ = system;
    component_ = component;
    if (accepted_ || !failure_.empty()) return;
    if (last_item_ >= 0) {
        if (now_us - asked_us_ > kSilence_us) {
            failure_ = name() + " upload: nothing heard after item " + std::to_string(last_item_);
        }
    } else if (announcements_ == 0 || now_us - asked_us_ > kAnnounceAgain_us) {
        if (announcements_++ >= kAnnouncements) {
            failure_ = name() + " upload: the autopilot does not ask for the items";
            return;
        }
        MissionCount count{};
        count.count = static_cast<uint16_t>(items_.size());
        count.target_system = system;
        count.target_component = component;
        count.mission_type = static_cast<uint8_t>(type_);
        link_.send(count);
        asked_us_ = now_us;
    }
}

void MissionUpload::take(const Frame& frame, uint64_t time_us) {
    if (accepted_ || !failure_.empty() || announcements_ == 0) return;
    if (auto request = as<MissionRequest>(frame))
        if (ours(request->mission_type)) answer(request->seq, false, time_us);
    if (auto request = as<MissionRequestInt>(frame))
        if (ours(request->mission_type)) answer(request->seq, true, time_us);
    if (auto ack = as<MissionAck>(frame)) {
        if (!ours(ack->mission_type)) return;
        accepted_ = ack->type == MavMissionResult::accepted;
        if (accepted_) return;
        // its store is busy with the parameters: announced again, as a user would
        const bool early = ack->type == MavMissionResult::error && last_item_ < 0;
        if (early && announcements_ < kAnnouncements) return;
        failure_ = name() + " refused: " + resultName(ack->type);
        if (last_item_ >= 0) failure_ += " at item " + std::to_string(last_item_);
    }
}

template <class Item>
Item MissionUpload::header(const WaypointItem& from) const {
    Item item{};
    item.param1 = static_cast<float>(from.params[0]);
    item.param2 = static_cast<float>(from.params[1]);
    item.param3 = static_cast<float>(from.params[2]);
    item.param4 = static_cast<float>(from.params[3]);
    item.z = static_cast<float>(from.altitude_m);
    item.seq = static_cast<uint16_t>(from.index);
    item.command = from.command;
    item.target_system = system_;
    item.target_component = component_;
    item.frame = from.frame;
    item.current = from.current;
    item.autocontinue = from.autocontinue;
    item.mission_type = static_cast<uint8_t>(type_);
    return item;
}

void MissionUpload::answer(int number, bool as_int, uint64_t time_us) {
    asked_us_ = time_us;
    if (number >= static_cast<int>(items_.size())) return;
    last_item_ = number;
    const WaypointItem& from = items_[static_cast<size_t>(number)];
    if (as_int) {
        auto item = header<MissionItemInt>(from);
        item.x = static_cast<int32_t>(std::lround(from.latitude_deg * 1e7));
        item.y = static_cast<int32_t>(std::lround(from.longitude_deg * 1e7));
        link_.send(item);
    } else {
        auto item = header<MissionItem>(from);
        item.x = static_cast<float>(from.latitude_deg);
        item.y = static_cast<float>(from.longitude_deg);
        link_.send(item);
    }
}

}  // namespace simulator
