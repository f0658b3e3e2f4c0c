// SPDX-License-Identifier: GPL-3.0-or-later
// One end of a MAVLink connection over a board's serial line: frames in, messages out.
#pragma once
#include <cstring>
#include <functional>
#include <optional>

#include "mavlink/messages.hpp"
#include "mavlink/peer.hpp"
#include "simulator/board.hpp"

namespace simulator {

constexpr uint8_t kGroundSystem = 255, kGroundComponent = 190;  // MAV_COMP_ID_MISSIONPLANNER

class Link {
public:
    using Handler = std::function<void(const mavlink::Frame&, uint64_t time_us)>;

    Link(Board& board, int usart, Handler handler)
        : board_(board), usart_(usart), handler_(std::move(handler)) {}

    int usart() const { return usart_; }
    void receive(uint8_t byte, uint64_t time_us);
    void setFraming(mavlink::Framing framing) { sender_.framing = framing; }
    void setComponent(uint8_t component) { sender_.component = component; }

    template <class Message>
    void send(const Message& message) {
        uint8_t bytes[mavlink::kLongestFrame];
        const uint16_t size = mavlink::encode(sender_, message, bytes);
        ++sender_.sequence;
        board_.send(usart_, bytes, size);
    }

private:
    Board& board_;
    const int usart_;
    Handler handler_;
    mavlink::PeerParser parser_;
    mavlink::Sender sender_{mavlink::Framing::v2, 0, kGroundSystem, kGroundComponent};
};

// The message when the frame is one.
template <class Message>
std::optional<Message> as(const mavlink::Frame& frame) {
    if (frame.id != mavlink::Wire<Message>::id) return std::nullopt;
    return frame.read<Message>();
}

}  // namespace simulator
