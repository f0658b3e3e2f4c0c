// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/gcs/telemetry.hpp"

#include "core/file_state.hpp"
#include "core/seldom.hpp"
#include "firmware/gcs/available_modes.hpp"
#include "firmware/gcs/commands.hpp"
#include "firmware/gcs/ftp.hpp"
#include "firmware/gcs/housekeeping.hpp"
#include "firmware/gcs/link.hpp"
#include "firmware/gcs/logs.hpp"
#include "firmware/gcs/mission_transfer.hpp"
#include "firmware/gcs/parameter_transfer.hpp"
#include "firmware/gcs/signing.hpp"
#include "firmware/gcs/signing_outgoing.hpp"
#include "firmware/notify/status_text.hpp"
#include "firmware/notify/text_queue.hpp"
#include "firmware/sensors/sensors.hpp"

namespace firmware {
namespace gcs {

using namespace notify;
using namespace state;
using namespace sensors;

namespace {

constexpr uint8_t kBytesAtOnce = 16;
constexpr uint8_t kHoldTicks = kTickRate_hz;  // a second, then the frame is refused
// Half a second: telemetry radios tear a frame for their turns of a fifth.
constexpr uint8_t kTornTicks = kTickRate_hz / 2;

constexpr uint8_t kNoRoomWakes = 0xFF;

struct Turn {
    bool usb;     // as link0 was opened
    bool pumped;  // telemetryPump has been called since the last turn
    bool second_first;
};
core::FileState<Turn> turn{};

// As the parameters give it: thousands, where the usual rates are named by their first digits.
uint32_t lineRate(int16_t thousands) {
    struct Row {
        int16_t thousands;
        uint32_t rate;
    };
    static constexpr Row kRates[] ROM = {{1, 1200},   {2, 2400},   {4, 4800},   {9, 9600},
                                         {19, 19200}, {38, 38400}, {57, 57600}, {115, 115200}};
    for (const Row& in_flash : kRates) {
        const Row row = core::romRead(in_flash);
        if (row.thousands == thousands) return row.rate;
    }
    return uint32_t{1000} * static_cast<uint16_t>(thousands);
}

void open(Link& link, int16_t thousands) {
    hal::serialOpen(portOf(link), lineRate(thousands));
    link.framing = mavlink::Framing::v1;
    link.slowdown_pct = 0;
    link.next_parameter = kNoParameter;
}

void openLink0() { open(links[0], turn.usb ? parameters.serial0_baud : parameters.serial1_baud); }

void followUsb() {
    if (usbPlugged() == turn.usb) return;
    turn.usb = !turn.usb;
    openLink0();
}

// Handles the frame the parser holds; false: not done, it stays there. Its signature is checked
// without room for an answer: what fills the port may wait for the same hash.
bool handleWhole(Link& link) {
    const mavlink::Frame frame = link.parser.frame();
    if (frame.framing == mavlink::Framing::v2) link.framing = mavlink::Framing::v2;
    if (!link.passed) {
        const Verdict verdict = signingVerdict(link, frame);
        if (verdict == Verdict::works) return true;
        if (verdict == Verdict::waits && link.held_ticks < kHoldTicks) return false;
        signingForget(link);
        link.passed = verdict == Verdict::obeyed;
    }
    if (link.passed && !hasRoom(link, kLongestTalk)) return false;
    if (link.passed && !handleFrame(link, frame)) {
        if (link.held_ticks < kHoldTicks) return false;
        refuseFrame(link, frame);
    }
    link.passed = false;
    link.held_ticks = 0;
    link.whole = link.parser.next();
    return true;
}

// A frame that lost a byte takes the first bytes of the next one for its own. That must not be an
// order that is obeyed when a third one comes, seconds later.
void giveUpTornFrame(Link& link) {
    if (link.whole || !link.parser.waits() || ++link.torn_ticks < kTornTicks) return;
    link.torn_ticks = 0;
    link.whole = link.parser.giveUp();
}

// For whose answers there is room.
// With what it calls inside, telemetryPump() could not be flat: the build fails.
__attribute__((noinline)) bool receive(Link& link) {
    if (link.whole) return handleWhole(link);
    uint8_t byte;
    for (uint8_t i = 0; i < kBytesAtOnce; ++i) {
        if (!hal::serialRead(portOf(link), byte)) return i > 0;
        link.torn_ticks = 0;
        if (!link.parser.put(byte)) continue;
        link.whole = true;
        handleWhole(link);
        break;
    }
    return true;
}

// Of what is sent, or else of what was received: they share the place for a hash.
SELDOM bool signOn(Link& link) {
    return signOutgoing(link) || (link.whole && !link.passed && handleWhole(link));
}

bool hasSomething(const Link& link) {
    return link.streams.due != 0 || link.next_parameter != kNoParameter || gcs::textWaits(link);
}

// Looked up some thousand times a second: flat, with what it calls inside, but not inlined itself,
// it takes 0.2 % of the processor less.
__attribute__((noinline, flatten)) uint8_t roomToDownload(const Link& link) {
    if (ftpWaits(link)) return signedSize(link, kFtpFrame);
    return logsWait(link) ? signedSize(link, kLogFrame) : kNoRoomWakes;
}

// Free bytes in the port at which there is something to send by itself.
uint8_t roomToSend(const Link& link) {
    if (hal::linkHeldSize(portOf(link)) != 0) return kAnyRoom;
    if (hasSomething(link)) return signedSize(link, kLargestFrame);
    return roomToDownload(link);
}

bool downloadSend(Link& link) { return !heartbeatDue(link) && (ftpSend(link) || logsSend(link)); }

bool sendOther(Link& link) {
    if (!hasRoom(link, signedSize(link, kLargestFrame))) return false;
    if (heartbeatDue(link)) return streamsSend(link);
    if (gcs::textWaits(link) && sendText(link)) return true;
    link.parameter_is_next = !link.parameter_is_next;
    if (link.parameter_is_next) return parameterListSend(link) || streamsSend(link);
    return streamsSend(link) || parameterListSend(link);
}

// One message, of what goes out by itself. A download takes turns with all the rest. Not inlined,
// as receive() is not.
__attribute__((noinline)) bool sendOne(Link& link) {
    const bool downloads = roomToDownload(link) != kNoRoomWakes;
    if (downloads) {
        link.download_is_next = !link.download_is_next;
        if (link.download_is_next && downloadSend(link)) return true;
    }
    return sendOther(link) || (downloads && downloadSend(link));
}

// Only interrupts run between telemetryPump's false and this.
template <uint8_t number>
inline bool waits() {
    const Link& link = links[number];
    constexpr hal::Port kPort = number == 0 ? hal::Port::link0 : hal::Port::link1;
    const uint8_t room = hal::serialRoom(kPort);
    if (room >= link.wake_room) return true;
    return hal::serialAvailable(kPort) > 0 && !link.whole && room >= kLongestTalk;
}

// True: something was done. While there is little room nothing can be, and what waits then waits.
template <uint8_t number>
inline bool pump() {
    Link& link = links[number];
    constexpr hal::Port kPort = number == 0 ? hal::Port::link0 : hal::Port::link1;
    if (link.wake_room == kAnyRoom && signOn(link)) return true;
    const uint8_t room = hal::serialRoom(kPort);
    if (room < kLongestTalk && link.wake_room != kNoRoomWakes) return false;
    if (room >= kLongestTalk && (link.whole || hal::serialAvailable(kPort) > 0) && receive(link))
        return true;
    link.wake_room = roomToSend(link);
    return room >= link.wake_room && sendOne(link);
}

}  // namespace

void telemetryStart() {
    housekeepingStart();
    missionTransferStart();
    commandsStart();
    logsStart();
    signingStart();
    turn.usb = usbPlugged();
    openLink0();
    open(links[1], parameters.serial2_baud);
    for (Link& link : links) streamsStart(link);
    sendBannerText();
}

void sendBannerText() {
    sendStatusText(Severity::info, STATUS_TEXT("ArduPilotMega autopilot, airplane"));
}

void telemetrySend() {
    followUsb();
    signingTick();
    for (Link& link : links) {
        if (link.whole && link.held_ticks < kHoldTicks) ++link.held_ticks;
        giveUpTornFrame(link);
        streamsTick(link);
        if (!turn.pumped) sendOne(link);
    }
    turn.pumped = false;
    sendCameraFeedback();
    sendHomePosition();
    sendAvailableModes();
    missionTransferTick();
    commandsTick();
}

// asked some thousand times a second: nothing in these is called that is not needed
// One link's turn at a time: a frame that is due waits for no more than that.
// Called in every round of the loop: flat it takes 0.15 % of the processor less, for 8 bytes.
__attribute__((flatten)) bool telemetryPump() {
    turn.pumped = true;
    turn.second_first = !turn.second_first;
    return turn.second_first ? pump<1>() || pump<0>() : pump<0>() || pump<1>();
}
// The same, 0.05 % for 58 bytes.
__attribute__((flatten)) bool telemetryWaits() { return waits<0>() || waits<1>(); }

}  // namespace gcs
}  // namespace firmware
