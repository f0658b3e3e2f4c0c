// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/log_tool/names.hpp"

#include "simulator/ground/telemetry.hpp"
#include "simulator/report/names.hpp"

namespace log_tool {
namespace {

constexpr char kOurs[] = "ArduPilotMega autopilot";

// -1: it has no such number, or none that fits.
int wholeOf(const Record& record, const char* label) {
    const double value = record[label];
    return value >= 0 && value <= 0xFFFF ? static_cast<int>(value) : -1;
}

}  // namespace

std::string banner(const LogFile& log) {
    for (const Record* text : log.named("MSG")) {
        const std::string said = text->text("Message");
        if (said.find(kOurs) == 0 || said.find("ArduPlane") == 0) return said;
    }
    return "";
}

Firmware firmwareOf(const LogFile& log) {
    return banner(log).find(kOurs) == 0 ? Firmware::ours : Firmware::another;
}

std::string meaningOf(const Record& record, Firmware firmware) {
    const std::string& name = record.kind->name;
    if (name == "MODE")
        return simulator::modeName(static_cast<uint32_t>(wholeOf(record, "ModeNum")));
    if (name == "EV") return simulator::logEventName(wholeOf(record, "Id"));
    if (name == "ERR")
        return simulator::logErrorName(wholeOf(record, "Subsys"), wholeOf(record, "ECode"),
                                       firmware == Firmware::ours);
    if (name == "LIST")
        return "mission id " + record.text("Mission") + ", fence " + record.text("Fence") +
               ", rally points " + record.text("Rally");
    return record.text("Message");
}

}  // namespace log_tool
