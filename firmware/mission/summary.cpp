// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/mission/command_table.hpp"
#include "firmware/mission/engine.hpp"
#include "firmware/mission/handlers.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/parameters.hpp"

namespace firmware {
namespace mission {

using namespace notify;
using namespace state;

uint8_t summarizeRecord(MissionSummary& summary, ::mission::Set set, const uint8_t* bytes,
                        ::mission::ItemPosition at) {
    if (at.index == 0) return ::mission::kNoRow;  // home
    const Record record = ::mission::unpack(set, bytes);
    const uint8_t row = kCommandTable.find(set, record.id);
    if (row == ::mission::kNoRow || kCommandTable.valid(row, record, at) != 0)
        return ::mission::kNoRow;
    constexpr uint8_t kLandStart = 0xBD;
    if (kCommandTable.act(row) == nothingToDo) {
        if (record.id != kLandStart)
            ++summary.idle;
        else if (summary.land_start == 0)
            summary.land_start = at.index;
    }
    const ::mission::Class kind = kCommandTable.kind(row);
    if (kind == ::mission::Class::nav) {
        if (summary.first_nav == 0) summary.first_nav = at.index;
        summary.last_nav = summary.last_run = at.index;
    }
    if (set == ::mission::Set::apm2 && kind == ::mission::Class::jump) {
        if (record.p3 != ::mission::kForEver) ++summary.counters;
        if (record.p1 <= summary.last_nav) summary.last_run = at.index;
    }
    return row;
}

core::Status summarizeStep(MissionSummary& summary, ::mission::Set set, uint8_t count,
                           ReadRecord read) {
    for (uint8_t n = 0; n < kRecordsPerCall && summary.next < count; ++n, ++summary.next) {
        uint8_t bytes[::mission::kRecordSize];
        const core::Status status = read(summary.next, bytes);
        if (status != core::Status::ok) return status;
        (void)summarizeRecord(summary, set, bytes, {summary.next, count});
    }
    return summary.next >= count ? core::Status::ok : core::Status::busy;
}

void reportWarnings(const MissionSummary& summary, ::mission::Set set, uint8_t count) {
    if (count < 2) return;
    if (summary.idle != 0)
        sendStatusText(Severity::notice, STATUS_TEXT("Mission: # items have no effect"),
                       summary.idle);
    if (summary.first_nav == 0)
        sendStatusText(Severity::warning, STATUS_TEXT("Mission has no NAV command"));
    else if (set == ::mission::Set::apm1 && summary.first_nav > 1)
        sendStatusText(Severity::warning, STATUS_TEXT("Mission: nothing before item # is run"),
                       summary.first_nav);
    else if (set == ::mission::Set::apm2 && summary.last_run + 1 < count &&
             parameters.mission_trailing == 0)
        sendStatusText(Severity::warning, STATUS_TEXT("Mission: nothing after item # is run"),
                       summary.last_run);
}

}  // namespace mission
}  // namespace firmware
