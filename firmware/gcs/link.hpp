// SPDX-License-Identifier: GPL-3.0-or-later
// One ground link: its parser, what the other end speaks, and what it still has to be sent.
// Answers are sent while their question is handled. So that they always find room, received
// bytes stay in the port's buffer until the longest answer fits, and a frame whose handler was
// answered `busy` stays in the parser until the handler is done with it.
#pragma once
#include <stdint.h>

#include "core/file_state.hpp"
#include "core/rom.hpp"
#include "firmware/gcs/streams.hpp"
#include "firmware/state/parameters.hpp"
#include "hal/serial.hpp"
#include "mavlink/messages.hpp"
#include "mavlink/parser.hpp"

namespace firmware {
namespace gcs {

struct IncomingTable {
    static uint8_t find(uint16_t id, mavlink::Accepted& to);
};

// Besides the payload, with a signature: there is room for one whether there is a key or not.
constexpr uint8_t kAroundPayload = mavlink::kHeaderV2 + mavlink::kChecksum + mavlink::kSignature;

// MISSION_ITEM_INT is, coming or going, the longest answer.
constexpr uint8_t kLongestTalk = kAroundPayload + sizeof(mavlink::MissionItemInt);

// SET_POSITION_TARGET_... is the longest message we take that has no answer.
constexpr uint8_t kLongestQuestion =
    mavlink::kHeaderV2 + sizeof(mavlink::SetPositionTargetGlobalInt) + mavlink::kChecksum;

// Whatever goes out by itself is only tried when the largest such frame would fit.
// Without its signature, unlike the two above: a line without a key is to be kept full.
constexpr uint8_t kLargestFrame =
    mavlink::kHeaderV2 + mavlink::Wire<mavlink::AutopilotVersion>::length + mavlink::kChecksum;

struct AskedModes {
    uint8_t next, last;  // indices of AVAILABLE_MODES; 0: none
};

struct Link {
    // what is used most first: an instruction reaches 63 bytes
    mavlink::Framing framing = mavlink::Framing::v1;
    uint8_t sequence = 0;
    bool whole = false;              // the parser holds a frame that is not handled yet ...
    bool passed = false;             // its signature was right, or none is asked for
    uint8_t held_ticks = 0;          // ... for so many turns of telemetrySend
    uint8_t torn_ticks = 0;          // turns of telemetrySend since a byte came for a frame begun
    uint8_t slowdown_pct = 0;        // of the streams, asked for by the radio
    uint8_t signature = 0;           // bytes of it behind what is sent; signingTick's to change
    uint8_t wake_room = 0;           // free bytes in the port at which there is something to send;
                                     // kAnyRoom: a signature is to be worked on
    bool parameter_is_next = false;  // while a list is sent, streams and list take turns
    bool download_is_next = false;   // likewise a log or a file and all else
    uint16_t next_parameter = 0;     // of the list being sent; kNoParameter: none
    mavlink::Parser<IncomingTable, kLongestQuestion> parser;
    Streams streams;
    AskedModes modes = {};
};
struct Links {
    Link of[state::kLinks];
    Link& operator[](uint8_t number) { return of[number]; }
    Link* begin() { return of; }
    Link* end() { return of + state::kLinks; }
};
extern core::FileState<Links> links;

inline uint8_t linkNumber(const Link& link) { return &link == links.of ? 0 : 1; }
static_assert(state::kLinks == 2, "more need more numbers");
inline hal::Port portOf(const Link& link) {
    return &link == links.of ? hal::Port::link0 : hal::Port::link1;
}
// A cable that somebody has plugged in: on link0, while the board senses USB. What a stranger with
// a radio must not do is obeyed there alone (docs/security.md).
bool isUsb(const Link& link);
bool usbPlugged();  // what follows the cable: the rate of link0

inline bool hasRoom(const Link& link, uint8_t frame_size) {
    return hal::serialRoom(portOf(link)) >= frame_size;
}
constexpr uint8_t kAnyRoom = 0;
inline uint8_t signedSize(const Link& link, uint8_t frame_size) {
    return static_cast<uint8_t>(frame_size + link.signature);
}

// What is sent as an answer or by an event, besides the rows of streams.cpp. send() finds a message
// here when it is compiled; its caller then names it by one byte.
constexpr mavlink::Layout kAnswers[] ROM = {
    mavlink::layoutOf<mavlink::Ping>(),
    mavlink::layoutOf<mavlink::ParamValue>(),
    mavlink::layoutOf<mavlink::MissionItem>(),
    mavlink::layoutOf<mavlink::MissionRequest>(),
    mavlink::layoutOf<mavlink::MissionCount>(),
    mavlink::layoutOf<mavlink::MissionAck>(),
    mavlink::layoutOf<mavlink::MissionRequestInt>(),
    mavlink::layoutOf<mavlink::MissionItemInt>(),
    mavlink::layoutOf<mavlink::CommandLong>(),
    mavlink::layoutOf<mavlink::CommandAck>(),
    mavlink::layoutOf<mavlink::Timesync>(),
    mavlink::layoutOf<mavlink::LogEntry>(),
    mavlink::layoutOf<mavlink::LogData>(),
    mavlink::layoutOf<mavlink::MagCalProgress>(),
    mavlink::layoutOf<mavlink::MagCalReport>(),
    mavlink::layoutOf<mavlink::MessageInterval>(),
    mavlink::layoutOf<mavlink::Statustext>(),
};
constexpr uint8_t answerOf(uint16_t id, uint8_t from = 0) {
    return from >= core::count(kAnswers) || kAnswers[from].id == id
               ? from
               : answerOf(id, static_cast<uint8_t>(from + 1));
}

// False: the whole frame does not fit now, nothing was sent. While a mission has switched the radio
// off, what does not go over USB is dropped.
bool sendPayload(Link& link, const void* payload, const mavlink::Layout& in_flash);
bool sendAnswer(Link& link, const void* payload, uint8_t answer);

template <class Message>
bool sendAs(Link& link, const void* message) {
    constexpr uint8_t kAnswer = answerOf(mavlink::Wire<Message>::id);
    static_assert(kAnswer < core::count(kAnswers), "not in kAnswers");
    return sendAnswer(link, message, kAnswer);
}
template <class Message>
bool send(Link& link, const Message& message) {
    return sendAs<Message>(link, &message);
}

bool textWaits(const Link& link);
bool sendText(Link& link);  // the oldest text this link has not had; false: none, or no room

// What the handlers of incoming frames share. A handler that returns false is called again with
// the same frame in a later turn; when that has lasted too long the frame is refused.
using Handler = bool (*)(Link& link, const mavlink::Frame& frame);
bool handleFrame(Link& link, const mavlink::Frame& frame);
void refuseFrame(Link& link, const mavlink::Frame& frame);

constexpr uint8_t kComponent = mavlink::MavComponent::autopilot1;

}  // namespace gcs
}  // namespace firmware
