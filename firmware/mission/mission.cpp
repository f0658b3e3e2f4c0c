// SPDX-License-Identifier: GPL-3.0-or-later
// The engine among the rest of the firmware: boot, AUTO, what its events mean.
#include "firmware/mission/mission.hpp"

#include "core/file_state.hpp"
#include "core/seldom.hpp"
#include "firmware/actuators/camera.hpp"
#include "firmware/control/inverted.hpp"
#include "firmware/mission/command_table.hpp"
#include "firmware/mission/engine.hpp"
#include "firmware/mission/handlers.hpp"
#include "firmware/mission/host.hpp"
#include "firmware/mission/servo_relay_events.hpp"
#include "firmware/mission/speed.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/vehicle.hpp"
#include "hal/clock.hpp"
#include "hal/eeprom.hpp"
#include "hal/trace.hpp"
#include "storage/index_store.hpp"
#include "storage/owner.hpp"

namespace firmware {
namespace mission {

using namespace notify;
using namespace state;
using namespace control;
using namespace actuators;

static_assert(storage::kRecordSlots <= ::mission::kMaxItems, "the engine has too few jump bits");
static_assert(storage::kRecordSize == ::mission::kRecordSize, "a slot holds a record");

core::FileState<storage::MissionStore> mission_store{};
core::FileState<MissionSummary> mission_summary{};

namespace {

using core::Status;
using ::mission::Event;

enum class Boot : uint8_t { owner, store, index, summary, done, foreign };
// What the index has yet to go through; in the next place once, if the first has not kept it.
enum IndexStep : uint8_t { kIndexDone, kIndexAgain, kIndexCheck, kIndexStore };
struct Run {
    Boot boot = Boot::owner;
    storage::IndexStore index_store;
    uint8_t index_wanted;  // to be saved over a loss of power
    uint8_t index_step;
    uint8_t reached;
    bool reached_waits;
    bool is_complete;
    bool armed;  // when it was looked at last
    bool flew;   // was seen flying since the start
    uint16_t skipped;
    uint16_t poll_began;  // ticks
};
core::FileState<Run> run{};

struct ModeRequest {
    Mode mode = Mode::automatic;  // of a command or the end; AUTO: none
};
core::FileState<ModeRequest> mode_request{};

Status readRecord(uint8_t index, uint8_t* to) { return mission_store.read(index, to); }
uint8_t countRecords() { return mission_store.count(); }

uint8_t generation() { return static_cast<uint8_t>(mission_store.generation()); }

void saveIndex(uint8_t index) {
    run.index_wanted = index;
    run.index_step = kIndexStore;
}

void ended(bool landed) {
    run.is_complete = true;
    resetSpeed();
    saveIndex(0);
    sendStatusText(Severity::notice, STATUS_TEXT("Mission complete"));
    if (!landed) mode_request.mode = Mode::rtl;
}

// At the end of a run: entering a mode leaves AUTO, and the engine may be in the middle of a pass.
void applyModeRequest() {
    const Mode mode = mode_request.mode;
    mode_request.mode = Mode::automatic;
    if (mode == Mode::automatic || host.enterMode(mode)) return;
    if (run.is_complete) {  // RTL without a home
        forgetPlace();
        holdPlace();
    } else {
        mission_engine.enter(false);
    }
}

void onReset() {
    run.is_complete = false;
    resetSpeed();
    stopEvents();
    cameraEvery(0);
    requestInverted(false);
    forgetPlace();
}

void onEvent(Event event, uint8_t index) {
    hal::traceItem(static_cast<uint8_t>(hal::kTraceMission + static_cast<uint8_t>(event)), index);
    if (event == Event::started || event == Event::waits || event == Event::runs)
        host.logCommand(index);
    Severity severity = Severity::warning;
    StatusText text;  // of the item
    switch (event) {
        case Event::started:
            saveIndex(index);
            severity = Severity::info;
            text = STATUS_TEXT("Mission item #");
            break;
        case Event::reached:
            rememberPlace();
            run.reached = index;
            run.reached_waits = true;
            break;
        case Event::skipped:
            ++run.skipped;
            text = STATUS_TEXT("Mission item # skipped");
            break;
        case Event::looped:
            text = STATUS_TEXT("Mission: jumps go round at item #");
            break;
        case Event::lost:
            severity = Severity::error;
            text = STATUS_TEXT("Mission item # cannot be read");
            break;
        case Event::hold:
            holdPlace();
            break;
        case Event::complete:
            ended(false);
            break;
        case Event::landed:
            ended(true);
            break;
        case Event::reset:
            onReset();
            break;
        default:
            break;
    }
    if (!text.isNone()) sendStatusText(severity, text, index);
}

// What a record costs depends on what it does: 50 us to look at, 400 to set a gain.
bool enough() {
    constexpr uint16_t kLongest = 1300 * hal::kTicksPerUs;
    return static_cast<uint16_t>(hal::ticks() - run.poll_began) > kLongest;
}

constexpr ::mission::Host kHost ROM = {readRecord, countRecords, onEvent, here, enough};

// Left alone by a watchdog or brown-out reset; the engine's checksum shows whether it still holds.
::mission::Memory memory __attribute__((section(".noinit")));

Status findStoredMission() {
    storage::Owner owner;
    const Status status = storage::findOwner(owner);
    if (status != Status::ok) return status;
    if (owner == storage::Owner::blank) {
        const Status claimed = storage::claim();
        if (claimed == Status::ok)
            sendStatusText(Severity::notice, STATUS_TEXT("EEPROM blank: defaults"));
        return claimed;
    }
    if (owner == storage::Owner::ours) {
        bool damaged;
        const Status mended = storage::mendMarks(damaged);
        if (mended == Status::ok && damaged) reportMemory();
        return mended;
    }
    sendStatusText(Severity::error, STATUS_TEXT("EEPROM belongs to other firmware"));
    run.boot = Boot::foreign;
    return Status::unsupported;
}

// Nothing is wiped: what a silent DataFlash holds may be there at the next start.
Status openLists() {
    storage::ListKind which;
    const Status status = mission_store.open(which);
    if (status == Status::ok || status == Status::busy) return status;
    if (status == Status::unsupported)
        sendStatusText(Severity::error, STATUS_TEXT("DataFlash does not answer"));
    else
        reportMemory();
    if (which == storage::ListKind::mission)
        missionLost();
    else
        sendStatusText(Severity::error, which == storage::ListKind::fence
                                            ? STATUS_TEXT("No fence: cannot be read")
                                            : STATUS_TEXT("No rally points: cannot be read"));
    return Status::busy;
}

// A damaged one is written over by what is left.
Status openIndex(uint8_t& index) {
    bool damaged = false;
    const Status status = run.index_store.open(generation(), index, damaged);
    run.index_wanted = index;
    if (damaged) {
        run.index_step = kIndexStore;
        reportMemory();
    }
    return status;
}

Status bootStep() {
    Status status = Status::ok;
    uint8_t index = 0;
    switch (run.boot) {
        case Boot::owner:
            status = findStoredMission();
            break;
        case Boot::store:
            status = openLists();
            break;
        case Boot::index:
            status = openIndex(index);
            if (status == Status::ok)
                mission_engine.boot(missionSet(), mission_store.generation(), host.memorySurvived(),
                                    index < mission_store.count() ? index : 0);
            break;
        case Boot::summary:
            status =
                summarizeStep(mission_summary, missionSet(), mission_store.count(), readRecord);
            if (status == Status::ok || status == Status::busy) break;
            missionLost();
            status = Status::ok;
            break;
        default:
            break;
    }
    if (status == Status::ok && run.boot < Boot::done)
        run.boot = static_cast<Boot>(static_cast<uint8_t>(run.boot) + 1);
    return status;
}

void storeIndex() {
    if (run.index_step == kIndexCheck) {
        storage::IndexStore stored;
        uint8_t index;
        bool damaged;
        if (!hal::eepromDrained() || stored.open(generation(), index, damaged) != Status::ok)
            return;
        run.index_step = kIndexDone;
        if (index == run.index_wanted) return;
        run.index_step = kIndexAgain;
        reportWorn();
    }
    if (run.index_step != kIndexDone &&
        run.index_store.write(generation(), run.index_wanted) == Status::ok)
        --run.index_step;
}

void background(bool there_is_time) {
    if (there_is_time) {
        listsRun();
        stepLanding();
    }
    mission_store.readAhead(mission_engine.next());
    storeIndex();
}

}  // namespace

core::FileState<::mission::Sequencer> mission_engine(::mission::Sequencer(kCommandTable, kHost,
                                                                          memory));

::mission::Set missionSet() {
    const uint8_t set = mission_store.set() != 0 ? mission_store.set()
                                                 : static_cast<uint8_t>(parameters.mission_set);
    return static_cast<::mission::Set>(set);
}

void missionLost() {
    mission_summary = {};
    mission_summary.next = kUnreadable;
    sendStatusText(Severity::error, STATUS_TEXT("No mission: cannot be read"));
}

namespace {

uint8_t poll() {
    run.poll_began = hal::ticks();
    return mission_engine.poll(parameters.mission_trailing != 0);
}

// Not where a flight goes on after a restart, until it has been seen flying again.
bool onGround() { return !vehicle.estimate.flying && (run.flew || !host.resumesFlight()); }

// Nothing goes on in another flight.
void beginAfresh() {
    missionRestart();
    if (run.index_wanted != 0) saveIndex(0);
}

// What the ground has chosen since the disarm counts. In AUTO a LAND ends with the disarm, and a
// TAKEOFF waits for arming.
void noticeArming() {
    if (vehicle.estimate.flying) run.flew = true;
    if (vehicle.armed == run.armed) return;
    run.armed = vehicle.armed;
    static_assert(Path::takeoff > Path::circle && Path::land > Path::takeoff, "the last ones");
    const bool waits = vehicle.demand.path >= Path::takeoff;
    const bool goes_on =
        mission_engine.active() ? run.armed || waits : run.armed && mission_engine.chosen();
    if (!goes_on && onGround()) beginAfresh();
    if (!run.armed || !onGround() || mission_summary.first_nav == 0) return;
    const uint8_t first = mission_engine.current();
    sendStatusText(Severity::info, STATUS_TEXT("AUTO begins at item #"),
                   first != 0 ? first : mission_summary.first_nav);
}

}  // namespace

SELDOM void missionBoot() {
    mission_store = storage::MissionStore();
    mission_summary = {};
    listsStart();
    run.index_step = kIndexDone;
    run.reached_waits = false;
    run.armed = vehicle.armed;
    run.flew = false;
    run.boot = Boot::owner;
    onReset();
    // enough for the largest mission; what a busy EEPROM keeps waiting is left to missionRun
    for (uint8_t i = 0; i < 80 && run.boot < Boot::done; ++i) (void)bootStep();
}

bool missionKnown() { return run.boot >= Boot::done; }
bool missionReady() { return run.boot == Boot::done; }
bool missionStorable() { return run.boot != Boot::foreign; }

void missionCatchUp() {
    if (!mission_engine.active() || missionChanging()) return;
    if (mission_engine.starved())
        mission_store.readAhead(mission_engine.next());
    else if (mission_engine.midPass())
        (void)poll();
}

void missionRun() {
    if (run.boot < Boot::done) {
        (void)bootStep();
        return;
    }
    if (run.boot == Boot::foreign) return;
    noticeArming();
    uint8_t records = 0;
    if (mission_engine.active() && !missionChanging()) {
        records = poll();
        if (mission_engine.active()) {
            stepSpeed();
            stepClimb();
        }
    }
    if (vehicle.mode == Mode::guided) stepSpeed();
    background(records <= ::mission::kRecordsPerPoll - kRecordsPerCall);
    applyModeRequest();
}

bool missionEnter(notify::StatusText& why_not) {
    why_not = StatusText();
    if (run.boot == Boot::foreign)
        why_not = STATUS_TEXT("AUTO: EEPROM belongs to other firmware");
    else if (run.boot != Boot::done || missionChanging())
        why_not = STATUS_TEXT("AUTO: mission is being read");
    else if (mission_summary.first_nav == 0)
        why_not = mission_summary.next == kUnreadable
                      ? STATUS_TEXT("AUTO: mission cannot be read")
                      : STATUS_TEXT("AUTO: mission has no NAV command");
    if (!why_not.isNone()) return false;
    run.is_complete = false;
    const bool flies_on = host.resumesFlight() && vehicle.mode == Mode::initialising;
    const bool again = parameters.mission_restart != 0 && !flies_on && !vehicle.failsafe_gives_back;
    noticeArming();
    mission_engine.enter(again || (!run.armed && onGround()));
    return true;
}

void missionLeave() {
    mission_engine.leave();
    if (!vehicle.armed && onGround()) beginAfresh();
}

void leaveForMode(Mode mode) {
    mode_request.mode = mode;
    mission_engine.leave();  // what follows waits until AUTO is entered again
}
bool missionComplete() { return run.is_complete; }
void missionRestart() { (void)mission_engine.setCurrent(0); }

uint16_t missionCount() { return mission_store.count(); }
uint16_t missionCurrent() { return mission_engine.current(); }
uint16_t missionSkipped() { return run.skipped; }

bool missionSetCurrent(uint16_t index) {
    const bool done = run.boot == Boot::done && !missionChanging() &&
                      mission_summary.first_nav != 0 && index < mission_store.count() &&
                      mission_engine.setCurrent(static_cast<uint8_t>(index));
    if (done) run.is_complete = false;
    return done;
}

bool takeReached(uint16_t& index) {
    if (!run.reached_waits) return false;
    run.reached_waits = false;
    index = run.reached;
    return true;
}

}  // namespace mission
}  // namespace firmware
