// SPDX-License-Identifier: GPL-3.0-or-later
// The firmware's own parser and sending, fed from memory with interrupts off: a byte taken by the
// parser, a message framed into the port's queue.
#include "firmware/gcs/link.hpp"
#include "steps.hpp"

namespace {

using mavlink::Framing;

uint8_t bytes[64];
uint8_t size;

bool take(uint8_t byte) {
    mavlink::Parser<firmware::gcs::IncomingTable, firmware::gcs::kLongestQuestion>& parser =
        firmware::gcs::links[0].parser;
    return parser.put(byte);
}

template <class Message>
void receive(costs::Step step, Framing framing, const Message& message, uint8_t expected) {
    size = 0;
    mavlink::writeFrame(
        [](const uint8_t* from, uint8_t count) {
            memcpy(bytes + size, from, count);
            size = static_cast<uint8_t>(size + count);
        },
        {framing, 1, 255, 190}, mavlink::outgoing(framing, message));
    bool whole = false;
    costs::timed(step, [&whole] {
        for (uint8_t i = 0; i < size; ++i) whole = take(bytes[i]);
    });
    if (!whole || size != expected) costs::broken();
    firmware::gcs::links[0].parser.next();
}

constexpr mavlink::Layout kHeartbeat ROM = mavlink::layoutOf<mavlink::Heartbeat>();
constexpr mavlink::Layout kPosition ROM = mavlink::layoutOf<mavlink::GlobalPositionInt>();
constexpr mavlink::Layout kText ROM = mavlink::layoutOf<mavlink::Statustext>();

void sendOne(costs::Step step, Framing framing, const void* message,
             const mavlink::Layout& in_flash) {
    hal::serialOpen(hal::Port::link0, 57600);
    firmware::gcs::links[0].framing = framing;
    costs::timed(step, [message, &in_flash] {
        firmware::gcs::sendPayload(firmware::gcs::links[0], message, in_flash);
    });
}

void receiveAll() {
    mavlink::Heartbeat beat = {};
    beat.mavlink_version = 3;
    receive(costs::kHeartbeat, Framing::v1, beat, costs::kHeartbeatBytes);
    mavlink::CommandLong command = {};
    command.command = 400;
    command.target_system = 1;
    command.target_component = 1;
    receive(costs::kCommand, Framing::v2, command, costs::kCommandBytes);
    mavlink::MissionItemInt item = {};
    item.autocontinue = 1;
    receive(costs::kItem, Framing::v2, item, costs::kItemBytes);
}

void receiveNoise() {
    uint32_t state = 1;
    for (uint16_t i = 0; i < 5000; ++i) {
        state = state * 1664525u + 1013904223u;  // Numerical Recipes' generator
        const uint8_t byte = static_cast<uint8_t>(state >> 24);
        costs::timed(costs::kNoise, [byte] { take(byte); });
    }
    for (uint16_t i = 0; i < 1000; ++i) {
        // at every second byte a PARAM_REQUEST_READ of the right length seems to begin
        const uint8_t byte = i % 2 ? 20 : mavlink::kMagicV1;
        costs::timed(costs::kFalseStarts, [byte] { take(byte); });
    }
}

void sendAll() {
    mavlink::Heartbeat beat = {};
    beat.mavlink_version = 3;
    sendOne(costs::kSendHeartbeat, Framing::v1, &beat, kHeartbeat);
    mavlink::GlobalPositionInt position = {};
    position.hdg = 0x0101;
    sendOne(costs::kSendPosition, Framing::v2, &position, kPosition);
    mavlink::Statustext text = {};
    memset(text.text, 'x', sizeof text.text);
    sendOne(costs::kSendText, Framing::v2, &text, kText);
}

}  // namespace

int main() {
    hal::trace(hal::kTraceFrameBegin);  // without frames nothing is measured
    receiveAll();
    receiveNoise();
    sendAll();
    for (uint8_t i = 0; i < 8; ++i) costs::timed(costs::kNothing, [] {});
    for (;;) {
    }
}
