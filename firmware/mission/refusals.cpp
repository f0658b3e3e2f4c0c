// SPDX-License-Identifier: GPL-3.0-or-later
// Why an item of an upload is refused, or the mission for one of its items, as a text for the
// pilot.
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

using ::mission::LongestPass;

constexpr uint8_t kProportional = 0x60, kForward = 0x64, kOtherRadio = 0x73;  // ids

enum class Reason : uint8_t {
    unknown = static_cast<uint8_t>(MissionResult::unsupported),
    frame = static_cast<uint8_t>(MissionResult::unsupported_frame),
    period = 0x40,  // no parameter plays the part of what the 1.0 set sets, but ...
    time,
    elevons,
    no_part,
    verdict = 0x80,
};
constexpr Reason of(LongestPass::Verdict verdict) {
    return static_cast<Reason>(static_cast<uint8_t>(Reason::verdict) +
                               static_cast<uint8_t>(verdict));
}

struct Row {
    Reason is;
    TextField<21> text;
};

// A parameter out of range has no text: the answer to the item says which it is.
constexpr Row kRows[] ROM = {
    {Reason::unknown, "Item # refused: command is not known"},
    {Reason::frame, "Item # refused: altitude's frame"},
    {Reason::period, "Item # refused: NAVL1_PERIOD instead"},
    {Reason::time, "Item # refused: TECS_TIME_CONST instead"},
    {Reason::elevons, "Item # refused: ELEVON_OUTPUT is 0"},
    {Reason::no_part, "Item # refused: no parameter for it"},
    {of(LongestPass::Verdict::goes_round), "Item # refused: jumps go round"},
    {of(LongestPass::Verdict::too_long), "Item # refused: over 1.5 s to next NAV"},
    {of(LongestPass::Verdict::too_many), "Item # refused: too many jumps"},
};

void report(Reason reason, uint16_t index) {
    for (const Row& in_flash : kRows)
        if (core::romRead(in_flash.is) == reason)
            return sendStatusText(Severity::warning, in_flash.text, index);
    sendStatusText(Severity::warning, STATUS_TEXT("Item # refused"), index);
}

// A gain or other radio value of an index that no parameter plays the part of; `unless`: it is not.
Reason noPart(const MissionItem& item, Reason unless) {
    constexpr uint8_t kNavRoll = 3, kGains = 8;
    const float which = item.param1;
    if (parameters.mission_set != 1 || item.command > kOtherRadio) return unless;
    const uint8_t id = static_cast<uint8_t>(item.command);
    const bool is_gain = id >= kProportional && id <= kForward;
    if ((!is_gain && id != kOtherRadio) || !(which >= 0 && which <= 255)) return unless;
    const uint8_t at = static_cast<uint8_t>(which);
    if ((is_gain ? gainSlot(id, at) : otherRadioSlot(at)) != kNoSlot) return unless;
    if (!is_gain && at < 2) return Reason::elevons;
    if (id != kProportional || at >= kGains) return Reason::no_part;
    return at == kNavRoll ? Reason::period : Reason::time;
}

}  // namespace

void reportRefused(uint16_t index, const MissionItem& item, MissionResult result) {
    const Reason reason = static_cast<Reason>(result);
    report(result == MissionResult::invalid_param1 ? noPart(item, reason) : reason, index);
}

void reportRefused(uint16_t index, LongestPass::Verdict verdict) { report(of(verdict), index); }

}  // namespace mission
}  // namespace firmware
