// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/log_tool/names.hpp"

#include <algorithm>
#include <iterator>

#include "simulator/ground/telemetry.hpp"

namespace log_tool {
namespace {

constexpr char kOurs[] = "ArduPilotMega autopilot";

struct Numbered {
    int number;
    const char* name;
};

// LogEvent of ArduPilot's AP_Logger, as far as an airplane has it.
constexpr Numbered kEvents[] = {
    {10, "armed"},
    {11, "disarmed"},
    {15, "auto armed"},
    {17, "landing perhaps complete"},
    {18, "on the ground"},
    {19, "GPS lost"},
    {25, "home set"},
    {28, "in the air"},
    {30, "autotune initialised"},
    {31, "autotune off"},
    {33, "autotune succeeded"},
    {34, "autotune failed"},
    {37, "autotune gains saved"},
    {41, "fence enabled"},
    {42, "fence disabled"},
    {49, "parachute disabled"},
    {50, "parachute enabled"},
    {51, "parachute released"},
    {52, "landing gear deployed"},
    {53, "landing gear retracted"},
    {54, "motors emergency stopped"},
    {55, "motors emergency stop cleared"},
};

// LogErrorSubsystem.
constexpr const char* kSubsystems[] = {nullptr,          "MAIN",         "RADIO",
                                       "COMPASS",        "OPTFLOW",      "FAILSAFE_RADIO",
                                       "FAILSAFE_BATT",  "FAILSAFE_GPS", "FAILSAFE_GCS",
                                       "FAILSAFE_FENCE", "FLIGHT_MODE",  "GPS",
                                       "CRASH_CHECK",    "FLIP",         "AUTOTUNE",
                                       "PARACHUTES",     "EKFCHECK",     "FAILSAFE_EKFINAV",
                                       "BARO",           "CPU",          "FAILSAFE_ADSB",
                                       "TERRAIN",        "NAVIGATION",   "FAILSAFE_TERRAIN",
                                       "EKF_PRIMARY",    "THRUST_LOSS",  "FAILSAFE_SENSORS",
                                       "FAILSAFE_LEAK",  "PILOT_INPUT",  "FAILSAFE_VIBE",
                                       "INTERNAL_ERROR", "DEADRECKON"};

struct Coded {
    int subsystem, code;
    const char* meaning;
};

// This firmware's: docs/failsafes.md and, of CPU, docs/restart.md; a test holds them together.
constexpr Coded kOurCodes[] = {
    {3, 1, "compass lost"},
    {5, 1, "radio lost: short failsafe"},
    {5, 2, "radio lost: long failsafe"},
    {6, 1, "battery low"},
    {7, 1, "position lost"},
    {8, 1, "ground station lost: failsafe"},
    {9, 1, "fence broken"},
    {11, 1, "GPS lost: dead reckoning"},
    {11, 2, "GPS jump refused"},
    {18, 1, "barometer lost"},
    {18, 2, "height lost: held by throttle"},
    {19, 0, "started by the supply"},
    {19, 1, "started by the reset button"},
    {19, 2, "restarted after a brown-out"},
    {19, 3, "restarted by watchdog"},
    {19, 4, "started by a reset"},
    {19, 5, "restarted by a fault"},
    {19, 6, "restarted as asked"},
    {26, 1, "inertial sensor lost"},
    {26, 2, "airspeed lost"},
};

// LogErrorCode, of the subsystems that an airplane's log has.
constexpr Coded kArduPilotCodes[] = {
    {1, 1, "inertial samples delayed"},
    {2, 2, "late frame"},
    {3, 1, "failed to initialise"},
    {3, 4, "unhealthy"},
    {11, 2, "glitch"},
    {12, 1, "crash, disarmed"},
    {12, 2, "loss of control"},
    {15, 2, "too low"},
    {15, 3, "landed"},
    {16, 2, "bad variance"},
    {18, 2, "glitch"},
    {18, 4, "unhealthy"},
    {18, 3, "bad depth"},
    {21, 2, "missing"},
};

template <size_t size>
std::string among(const Coded (&codes)[size], int subsystem, int code) {
    const auto found = std::find_if(std::begin(codes), std::end(codes), [&](const Coded& each) {
        return each.subsystem == subsystem && each.code == code;
    });
    return found == std::end(codes) ? "" : found->meaning;
}

std::string codeName(int subsystem, int code, Firmware firmware) {
    const std::string known = firmware == Firmware::ours ? among(kOurCodes, subsystem, code)
                                                         : among(kArduPilotCodes, subsystem, code);
    if (!known.empty()) return known;
    if (code == 0) return "resolved";
    if (code == 1 && firmware == Firmware::another) return "failsafe occurred";
    return "code " + std::to_string(code);
}

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

std::string eventName(int id) {
    for (const Numbered& event : kEvents)
        if (event.number == id) return event.name;
    return "event " + std::to_string(id);
}

std::string errorName(int subsystem, int code, Firmware firmware) {
    const bool known = subsystem > 0 && subsystem < static_cast<int>(std::size(kSubsystems));
    return (known ? std::string(kSubsystems[subsystem])
                  : "subsystem " + std::to_string(subsystem)) +
           ": " + codeName(subsystem, code, firmware);
}

std::string meaningOf(const Record& record, Firmware firmware) {
    const std::string& name = record.kind->name;
    if (name == "MODE")
        return simulator::modeName(static_cast<uint32_t>(wholeOf(record, "ModeNum")));
    if (name == "EV") return eventName(wholeOf(record, "Id"));
    if (name == "ERR")
        return errorName(wholeOf(record, "Subsys"), wholeOf(record, "ECode"), firmware);
    return record.text("Message");
}

}  // namespace log_tool
