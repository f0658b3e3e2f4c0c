// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/logger/log.hpp"

#include <string.h>

#include "core/file_state.hpp"
#include "core/internal_error.hpp"
#include "core/rom.hpp"
#include "firmware/actuators/camera.hpp"
#include "firmware/logger/records.hpp"
#include "firmware/logger/sources.hpp"
#include "firmware/mission/host.hpp"
#include "firmware/mission/mission.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/notify/text_queue.hpp"
#include "firmware/safety/failsafe_table.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/published.hpp"
#include "hal/clock.hpp"
#include "hal/page_flash.hpp"
#include "hal/watchdog.hpp"
#include "storage/log_base.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<LoggerState> : Writable<LoggerState> {
    using Writable::state;
};
}  // namespace state

namespace logger {

using namespace notify;
using namespace state;
using namespace actuators;
using namespace mission;
using namespace safety;

core::FileState<logging::LogStore> flight_logs{};

namespace {

constexpr LoggerState& published = Publisher<LoggerState>::state();

// Bits of LOG_BITMASK as ArduPlane counts them.
namespace Bit {
enum : uint8_t {
    attitude_fast = 0,
    attitude = 1,
    gps = 2,
    performance = 3,
    control = 4,
    navigation = 5,
    mode = 6,
    inertial = 7,
    command = 8,
    current = 9,
    compass = 10,
    speed_height = 11,
    camera = 12,
    radio = 13,
    disarmed = 16,
    inertial_fast = 19,
};
}

// When a source is due: at a place in a round of so many runs of 20 ms, or with each fix.
enum Round : uint8_t { always, of_5, of_10, with_fix, kRounds };

struct Source {
    uint32_t kinds;
    uint8_t round;
    uint8_t place;  // spread, so that they do not all come at once
    bool (*put)();
};

constexpr Source source(uint8_t bit, Round round, uint8_t place, bool (*put)()) {
    return {static_cast<uint32_t>(1) << bit, round, place, put};
}

constexpr uint32_t kAnyAttitude = 1 << Bit::attitude_fast | 1 << Bit::attitude;

// Once or twice a second, one each tenth of it.
struct SlowSource {
    uint16_t kinds;
    bool (*put)();
};
constexpr SlowSource slow(uint8_t bit, bool (*put)()) {
    return {static_cast<uint16_t>(1U << bit), put};
}
// clang-format off
constexpr SlowSource kSlowSources[] ROM = {
    slow(Bit::performance,  putPerformance),
    slow(Bit::navigation,   putNavigation),
    slow(Bit::speed_height, putSpeedHeight),
    slow(Bit::control,      putAirspeed),
    slow(Bit::current,      putBattery),
    slow(Bit::inertial,     putVibration),
    slow(Bit::navigation,   putNavigation),
    slow(Bit::speed_height, putSpeedHeight),
    slow(Bit::attitude,     putAttitude2),
    slow(Bit::current,      putPower),
};
// clang-format on
bool putSlow();
bool putLoops();  // roll, pitch and yaw in turn

// clang-format off
constexpr Source kSources[] ROM = {
    source(Bit::gps,           with_fix, 0, putGps),
    source(Bit::attitude_fast, always,   0, putAttitude),
    source(Bit::inertial_fast, always,   0, putInertial),
    source(Bit::attitude,      of_5,     0, putAttitude),
    source(Bit::inertial,      of_5,     1, putInertial),
    {0xFFFF,                   of_5,     1, putSlow},
    source(Bit::radio,         of_10,    0, putRadioIn),
    source(Bit::control,       of_10,    2, putControl),
    source(Bit::control,       of_10,    9, putBarometer),
    source(Bit::radio,         of_10,    5, putServoOut),
    source(Bit::navigation,    of_10,    7, putPlace),
    source(Bit::compass,       of_10,    8, putCompass),
    {kAnyAttitude,             of_10,    4, putLoops},
};
// clang-format on
constexpr uint8_t kSourceCount = core::count(kSources);
constexpr uint8_t kRound = 50;
static_assert(kSourceCount <= 16, "a bit each");
static_assert(core::count(kSlowSources) == kRound / 5, "each has its turn");

// A run stops beginning records after so long: what is left comes in the next.
constexpr uint16_t kSpend = 400 * hal::kTicksPerUs;
constexpr uint8_t kMaxRecords = 4;
constexpr uint16_t kSpendBeforePrelude = 520 * hal::kTicksPerUs;

// What begins or ends is an event; what fails, an error with its code, or 0 when it is over.
struct State {
    uint8_t begins, ends;
};
enum : uint8_t { kArmed = 1, kFlying = 2 };  // a bit for each row

// Numbers as ArduCopter's logs have them, ArduPlane's have none.
// clang-format off
constexpr State kStates[] ROM = {
    {10, 11},  // kArmed
    {28, 18},  // kFlying
};
// clang-format on

constexpr uint8_t kProcessor = 19;  // with the cause of its last reset

// Before anything that happens: the formats, the banner, why the board started.
constexpr uint16_t kIntroduction = kFormats + 2;

constexpr uint8_t kCommands = 4;
constexpr uint8_t kNoMode = 0xFF;

enum class Request : uint8_t { none, pause, erase };
struct Progress {
    uint16_t prelude;  // formats, banner, lists, units, parameters, items that are in it already
    uint16_t due;      // a bit a source
    uint16_t dropped;
    uint8_t run;       // 0 .. kRound - 1
    uint8_t states;    // as logged
    uint16_t failing;  // as logged
    uint8_t internal_errors;
    uint8_t mode;
    uint8_t triggers_logged;
    uint32_t gps_logged_ms;  // when the newest fix came that has been seen here
    uint8_t commands[kCommands];
    uint8_t commands_waiting;
    uint8_t dropped_reported;
    Request request;
};
core::FileState<Progress> logged{};

uint32_t wantedKinds() {
    uint32_t kinds = static_cast<uint32_t>(parameters.log_bitmask);
    if (kinds & 1UL << Bit::attitude_fast) kinds &= ~(1UL << Bit::attitude);
    if (kinds & 1UL << Bit::inertial_fast) kinds &= ~(1UL << Bit::inertial);
    return kinds;
}

bool wants(uint8_t bit) { return (static_cast<uint32_t>(parameters.log_bitmask) >> bit & 1) != 0; }

void drop() {
    if (logged.dropped != 0xFFFF) ++logged.dropped;
}

// In which place of its round each kind is now.
struct Places {
    uint8_t of[kRounds];
};

Places places() {
    Places now = {
        {0, static_cast<uint8_t>(logged.run % 5), static_cast<uint8_t>(logged.run % 10), 1}};
    if (vehicle.gps.received_ms != logged.gps_logged_ms) now.of[with_fix] = 0;
    logged.gps_logged_ms = vehicle.gps.received_ms;
    return now;
}

void findDue() {
    if (++logged.run == kRound) logged.run = 0;
    const uint32_t kinds = wantedKinds();
    const Places now = places();
    uint16_t bit = 1;
    for (const Source& in_flash : kSources) {
        if (now.of[core::romRead(in_flash.round)] == core::romRead(in_flash.place) &&
            (kinds & core::romRead(in_flash.kinds)) != 0) {
            if ((logged.due & bit) != 0) drop();
            logged.due |= bit;
        }
        bit <<= 1;
    }
}

bool putSlow() {
    const SlowSource source = core::romRead(kSlowSources[logged.run / 5]);
    return (static_cast<uint16_t>(parameters.log_bitmask) & source.kinds) == 0 || source.put();
}

bool putLoops() { return putLoop(static_cast<control::Loop>(logged.run / 10 % 3)); }

bool putDue() {
    if (logged.due == 0) return false;
    uint16_t bit = 1;
    for (const Source& in_flash : kSources) {
        if ((logged.due & bit) != 0) {
            if (!core::romRead(in_flash.put)()) return false;
            logged.due &= static_cast<uint16_t>(~bit);
            return true;
        }
        bit <<= 1;
    }
    return false;
}

// The next part of what every log begins with; false: it is whole, or has to wait.
bool putPrelude() {
    uint16_t at = logged.prelude;
    bool ok;
    if (at < kFormats) {
        ok = putFormat(static_cast<uint8_t>(at));
    } else if ((at -= kFormats) == 0) {
        ok = putBanner();
    } else if (--at == 0) {
        ok = putError(kProcessor, static_cast<uint8_t>(hal::resetCause()));
    } else if (--at == 0) {
        ok = putLists();
    } else if (--at < kUnits) {
        ok = putUnit(static_cast<uint8_t>(at));
    } else if ((at -= kUnits) < kMultipliers) {
        ok = putMultiplier(static_cast<uint8_t>(at));
    } else if ((at -= kMultipliers) < kFormats) {
        ok = putUnits(static_cast<uint8_t>(at));
    } else if ((at -= kFormats) < parameterCount()) {
        ok = putParameter(static_cast<uint8_t>(at));
    } else if ((at -= parameterCount()) < missionCount() && wants(Bit::command)) {
        ok = putCommand(static_cast<uint8_t>(at));
    } else {
        return false;
    }
    if (ok) ++logged.prelude;
    return ok;
}

bool putState() {
    const uint8_t now = static_cast<uint8_t>((vehicle.armed ? kArmed : 0) |
                                             (vehicle.estimate.flying ? kFlying : 0));
    uint8_t bit = 1;
    for (const State& in_flash : kStates) {
        if (((now ^ logged.states) & bit) != 0) {
            const State state = core::romRead(in_flash);
            const bool ok = putEvent((now & bit) != 0 ? state.begins : state.ends);
            if (ok) logged.states ^= bit;
            return ok;
        }
        bit = static_cast<uint8_t>(bit << 1);
    }
    return false;
}

bool putFailure() {
    if (vehicle.failing == logged.failing) return false;
    uint16_t bit = 1;
    for (const CauseRow& cause : kCauseTable) {
        if (((vehicle.failing ^ logged.failing) & bit) != 0) {
            const uint8_t code = (vehicle.failing & bit) != 0 ? core::romRead(cause.code) : 0;
            const bool ok = putError(core::romRead(cause.subsystem), code);
            if (ok) logged.failing ^= bit;
            return ok;
        }
        bit = static_cast<uint16_t>(bit << 1);
    }
    return false;
}

bool putChange() {
    const uint8_t now = static_cast<uint8_t>(vehicle.mode);
    if (now != logged.mode && wants(Bit::mode)) {
        if (!putMode()) return false;
        logged.mode = now;
        return true;
    }
    const uint8_t triggers = static_cast<uint8_t>(cameraTriggerCount());
    if (triggers != logged.triggers_logged && wants(Bit::camera)) {
        if (!putCameraFeedback()) return false;
        logged.triggers_logged = triggers;
        return true;
    }
    if (logged.commands_waiting == 0) return false;
    const uint8_t index = logged.commands[0];
    if (!(index == kNoItem ? putLists() : putCommand(index))) return false;
    --logged.commands_waiting;
    memmove(logged.commands, logged.commands + 1, logged.commands_waiting);
    return true;
}

// ERR's subsystem 30 is ArduPilot's INTERNAL_ERROR.
bool putInternalError() {
    constexpr uint8_t kInternalError = 30;
    const core::InternalErrors& errors = core::internalErrors();
    if (errors.changes == logged.internal_errors) return false;
    if (!putError(kInternalError, static_cast<uint8_t>(errors.last))) return false;
    logged.internal_errors = errors.changes;
    return true;
}

bool putEvents() {
    return putState() || putInternalError() || putFailure() || putChange() || putText();
}

// What happened goes first, then what is measured, and beside it the rest of the prelude.
void putSome() {
    const uint16_t began = hal::ticks();
    const auto within = [began](uint16_t spend) {
        return static_cast<uint16_t>(hal::ticks() - began) < spend;
    };
    if (logged.prelude >= kFormats) {
        const bool introduced = logged.prelude >= kIntroduction;
        if (introduced) (void)putEvents();
        (void)putDue();  // however long the event took, or a mission's changes would hold it up
        for (uint8_t i = 2; i < kMaxRecords && within(kSpend); ++i)
            if (!(introduced && putEvents()) && !putDue()) break;
    }
    if (within(kSpendBeforePrelude)) (void)putPrelude();
}

void begin() {
    if (flight_logs.begin() != core::Status::ok) return;
    logged.prelude = logged.due = 0;
    (void)places();  // a fix from before is none of this log's
    logged.states = logged.commands_waiting = 0;
    logged.failing = logged.internal_errors = 0;
    logged.mode = kNoMode;
    logged.triggers_logged = static_cast<uint8_t>(cameraTriggerCount());
}

void end() {
    while (putEvents()) {
    }
    if (hal::flashBusy()) return;  // it may have kept one out
    const core::Status status = flight_logs.end();
    (void)status;  // busy: in the next run
}

void reportDropped() {
    if (logged.run != 0 || static_cast<uint8_t>(logged.dropped) == logged.dropped_reported) return;
    logged.dropped_reported = static_cast<uint8_t>(logged.dropped);
    sendStatusText(Severity::warning, STATUS_TEXT("Log: # records dropped"), logged.dropped);
}

uint16_t readBase() {
    uint16_t base;
    while (storage::readLogBase(base) == core::Status::busy) {
    }
    return base;
}

// A changed bit. When the EEPROM is busy, at the next start.
void mendBase(uint16_t base) {
    if (base == storage::kNoLogBase) return;
    const core::Status status = storage::writeLogBase(base);
    (void)status;
}

void eraseMore() {
    if (!flight_logs.erasing()) {
        (void)flight_logs.erase();
    } else if (flight_logs.eraseStep() &&
               storage::writeLogBase(flight_logs.nextBase()) == core::Status::ok) {
        flight_logs.finishErase();
        logged.request = Request::none;
        sendStatusText(Severity::notice, STATUS_TEXT("Logs erased"));
    }
}

void armedMeanwhile() {
    if (logged.request == Request::erase)
        sendStatusText(Severity::warning, STATUS_TEXT("Erasing logs stopped"));
    logged.request = Request::none;
}

}  // namespace

void logStart() {
    const uint16_t base = readBase();
    flight_logs.start(base);
    mendBase(base);
    logged.due = logged.dropped = logged.prelude = 0;
    logged.run = logged.dropped_reported = 0;
    logged.request = Request::none;
}

// Inlined into main(), its variables would lie below every task on the stack: 44 bytes.
__attribute__((noinline)) bool logFind() {
    const bool looked = flight_logs.find();
    if (looked && flight_logs.ready() && flight_logs.last() == 0)
        sendStatusText(Severity::info, STATUS_TEXT("No logs"));
    return looked;
}

void logPause(bool pause) { logged.request = pause ? Request::pause : Request::none; }

void logErase() {
    if (vehicle.armed) return sendStatusText(Severity::error, STATUS_TEXT("Disarm to erase logs"));
    if (!flight_logs.usable())
        return sendStatusText(Severity::error, STATUS_TEXT("No logs to erase"));
    logged.request = Request::erase;
    sendStatusText(Severity::notice, STATUS_TEXT("Erasing logs"));
}

uint16_t logDropped() { return logged.dropped; }

void logCommand(uint8_t index) {
    if (!logOpen() || !wants(Bit::command)) return;
    if (logged.commands_waiting == kCommands) return drop();
    logged.commands[logged.commands_waiting++] = index;
}

bool logParameter(uint8_t row) {
    return !logOpen() || (logged.prelude >= kFormats && putParameter(row));
}

namespace {

void stepLog() {
    if (vehicle.armed && logged.request != Request::none) armedMeanwhile();
    const bool wanted = parameters.log_bitmask != 0 && logged.request == Request::none &&
                        (vehicle.armed || wants(Bit::disarmed));
    if (!flight_logs.writing()) {
        if (wanted) begin();
        if (logged.request == Request::erase) eraseMore();
        return;
    }
    if (!wanted) return end();
    if (hal::flashTrouble() != hal::FlashTrouble::none) return flight_logs.start(0);
    if (logged.prelude >= kFormats) findDue();
    putSome();
    reportDropped();
}

}  // namespace

void runLog() {
    stepLog();
    setTextReader(kLogReader, logOpen());
    published.log_usable = flight_logs.usable();
}

}  // namespace logger
}  // namespace firmware
