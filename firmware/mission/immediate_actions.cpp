// SPDX-License-Identifier: GPL-3.0-or-later
// Actions that are ordered from the ground: the mission's own rows, outside of a mission.
#include "firmware/mission/command_table.hpp"
#include "firmware/mission/item.hpp"
#include "firmware/mission/mission.hpp"

namespace firmware {
namespace mission {

MissionResult missionAct(const MissionItem& item) {
    ::mission::Record record;
    EncodeWarnings warnings;
    const MissionResult result = encodeItem(::mission::Set::apm2, {1, 2}, item, record, warnings);
    if (result != MissionResult::accepted) return result;
    const uint8_t row = kCommandTable.find(::mission::Set::apm2, record.id);
    if (kCommandTable.kind(row) != ::mission::Class::action) return MissionResult::unsupported;
    kCommandTable.act(row)(record);
    return result;
}

}  // namespace mission
}  // namespace firmware
