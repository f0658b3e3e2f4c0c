// SPDX-License-Identifier: GPL-3.0-or-later
// Why an item of an upload is refused, as a text for the pilot.
#include "core/rom.hpp"
#include "firmware/mission/engine.hpp"
#include "firmware/mission/handlers.hpp"
#include "firmware/mission/item.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/parameters.hpp"

namespace firmware {
namespace mission {

using namespace notify;
using namespace state;

namespace {

constexpr uint8_t kProportional = 0x60, kForward = 0x64, kOtherRadio = 0x73;  // ids

struct Reason {
    uint8_t is;
    char text[42];
};

// A parameter out of range has no text: the answer to the item says which it is.
constexpr Reason kReasons[] ROM = {
    {static_cast<uint8_t>(MissionResult::unsupported), "Item # refused: command is not known"},
    {static_cast<uint8_t>(MissionResult::unsupported_frame), "Item # refused: altitude's frame"},
};

// Where no parameter plays the part of what the 1.0 set sets; docs/mission.md has the table.
enum NoPart : uint8_t { period, time, elevons, none };
constexpr Reason kNoPart[] ROM = {
    {period, "Item # refused: NAVL1_PERIOD instead"},
    {time, "Item # refused: TECS_TIME_CONST instead"},
    {elevons, "Item # refused: ELEVON_OUTPUT is 0"},
    {none, "Item # refused: no parameter for it"},
};

NoPart noPart(uint8_t id, uint8_t index) {
    constexpr uint8_t kNavRoll = 3, kGains = 8;
    if (id == kOtherRadio) return index < 2 ? elevons : none;
    if (id != kProportional || index >= kGains) return none;
    return index == kNavRoll ? period : time;
}

template <size_t count>
bool report(const Reason (&reasons)[count], uint8_t is, uint16_t index) {
    for (const Reason& in_flash : reasons) {
        if (core::romRead(in_flash.is) != is) continue;
        sendStatusText(Severity::warning, in_flash.text, index);
        return true;
    }
    return false;
}

// A gain or other radio value of an index that no parameter plays the part of.
bool reportNoPart(uint16_t index, const MissionItem& item) {
    const float which = item.param1;
    if (parameters.mission_set != 1 || item.command > kOtherRadio) return false;
    const uint8_t id = static_cast<uint8_t>(item.command);
    const bool is_gain = id >= kProportional && id <= kForward;
    if ((!is_gain && id != kOtherRadio) || !(which >= 0 && which <= 255)) return false;
    const uint8_t at = static_cast<uint8_t>(which);
    if ((is_gain ? gainSlot(id, at) : otherRadioSlot(at)) != kNoSlot) return false;
    return report(kNoPart, noPart(id, at), index);
}

}  // namespace

void reportRefused(uint16_t index, const MissionItem& item, MissionResult result) {
    if (result == MissionResult::invalid_param1 && reportNoPart(index, item)) return;
    if (!report(kReasons, static_cast<uint8_t>(result), index))
        sendStatusText(Severity::warning, ROM_TEXT("Item # refused"), index);
}

}  // namespace mission
}  // namespace firmware
