// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/chaos/station.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace simulator::chaos {
namespace {

using namespace mavlink;
using Words = std::vector<std::string>;

constexpr uint8_t kVehicle = 1, kComponent = 1, kReal32 = 9;
constexpr int kUsb = 0;

double value(const std::string& word) { return std::strtod(word.c_str(), nullptr); }
float valueF(const std::string& word) { return static_cast<float>(value(word)); }
template <class Integer>
Integer integer(const std::string& word) {
    return static_cast<Integer>(std::strtol(word.c_str(), nullptr, 10));
}

template <class Message>
Message toVehicle() {
    Message message{};
    message.target_system = kVehicle;
    message.target_component = kComponent;
    return message;
}

void param(Link& link, const Words& words) {
    auto message = toVehicle<ParamSet>();
    words[2].copy(message.param_id, sizeof message.param_id);
    message.param_value = valueF(words[3]);
    message.param_type = kReal32;
    link.send(message);
}

void mode(Link& link, const Words& words) {
    SetMode message{};
    message.target_system = kVehicle;
    message.base_mode = MavModeFlag::custom_mode_enabled;
    message.custom_mode = integer<uint32_t>(words[2]);
    link.send(message);
}

void command(Link& link, const Words& words) {
    auto message = toVehicle<CommandLong>();
    message.command = integer<uint16_t>(words[2]);
    message.param1 = valueF(words[3]);
    message.param2 = valueF(words[4]);
    message.param3 = valueF(words[5]);
    message.param4 = valueF(words[6]);
    message.param5 = valueF(words[7]);
    message.param6 = valueF(words[8]);
    message.param7 = valueF(words[9]);
    link.send(message);
}

void override_(Link& link, const Words& words) {
    auto message = toVehicle<RcChannelsOverride>();
    message.chan1_raw = integer<uint16_t>(words[2]);
    message.chan2_raw = integer<uint16_t>(words[3]);
    message.chan3_raw = integer<uint16_t>(words[4]);
    message.chan4_raw = integer<uint16_t>(words[5]);
    message.chan5_raw = integer<uint16_t>(words[6]);
    message.chan6_raw = integer<uint16_t>(words[7]);
    message.chan7_raw = integer<uint16_t>(words[8]);
    message.chan8_raw = integer<uint16_t>(words[9]);
    link.send(message);
}

void current(Link& link, const Words& words) {
    auto message = toVehicle<MissionSetCurrent>();
    message.seq = integer<uint16_t>(words[2]);
    link.send(message);
}

void count(Link& link, const Words& words) {
    auto message = toVehicle<MissionCount>();
    message.count = integer<uint16_t>(words[2]);
    link.send(message);
}

void clear(Link& link, const Words&) { link.send(toVehicle<MissionClearAll>()); }

void item(Link& link, const Words& words) {
    auto message = toVehicle<MissionItemInt>();
    message.seq = integer<uint16_t>(words[2]);
    message.command = integer<uint16_t>(words[3]);
    message.frame = integer<uint8_t>(words[4]);
    message.param1 = valueF(words[5]);
    message.param2 = valueF(words[6]);
    message.param3 = valueF(words[7]);
    message.param4 = valueF(words[8]);
    message.x = static_cast<int32_t>(std::lround(value(words[9]) * 1e7));
    message.y = static_cast<int32_t>(std::lround(value(words[10]) * 1e7));
    message.z = valueF(words[11]);
    message.autocontinue = 1;
    link.send(message);
}

using Send = void (*)(Link&, const Words&);
const std::map<std::string, Send> kSenders = {
    {"param", param},     {"mode", mode},   {"command", command}, {"override", override_},
    {"current", current}, {"count", count}, {"clear", clear},     {"item", item},
};

std::vector<uint8_t> bytesOf(const std::string& hex) {
    std::vector<uint8_t> bytes;
    for (size_t i = 0; i + 1 < hex.size(); i += 2)
        bytes.push_back(static_cast<uint8_t>(std::strtoul(hex.substr(i, 2).c_str(), nullptr, 16)));
    return bytes;
}

}  // namespace

EventStation::EventStation(Board& board, int telemetry_usart)
    : board_(board),
      telemetry_(board, telemetry_usart, [](const Frame&, uint64_t) {}),
      usb_(board, kUsb, [](const Frame&, uint64_t) {}) {}

bool EventStation::sends(const Event& event) {
    return kSenders.count(event.kind()) != 0 || event.kind() == "frame" || event.kind() == "noise";
}

void EventStation::send(const Event& event) {
    const auto found = kSenders.find(event.kind());
    if (found == kSenders.end()) return sendRaw(event);
    found->second(on(event.words[1]), event.words);
}

// A frame whose checksum is right, whatever is in it; or bytes that are none.
void EventStation::sendRaw(const Event& event) {
    const int usart = on(event.words[1]).usart();
    if (event.kind() == "noise") {
        const auto noise = bytesOf(event.words[2]);
        return board_.send(usart, noise.data(), noise.size());
    }
    const auto id = integer<uint16_t>(event.words[2]);
    Accepted message{};
    if (AllMessages::find(id, message) == kNoRow) return;
    std::vector<uint8_t> payload = bytesOf(event.words[3]), frame;
    payload.resize(std::max<size_t>(payload.size(), 1));
    const Sender sender{Framing::v2, 0, kGroundSystem, kGroundComponent};
    const auto length = static_cast<uint8_t>(std::min<size_t>(payload.size(), 255));
    writeFrame(
        [&](const uint8_t* bytes, uint8_t size) { frame.insert(frame.end(), bytes, bytes + size); },
        sender, Outgoing{payload.data(), id, length, message.crc_extra});
    board_.send(usart, frame.data(), frame.size());
}

}  // namespace simulator::chaos
