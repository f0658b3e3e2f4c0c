// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/invariants/watched_board.hpp"

#include <algorithm>
#include <cstdio>

#include "simulator/devices/ppm_encoder.hpp"
#include "simulator/ground/link.hpp"

namespace simulator {

constexpr uint64_t kFrame_us = 10'000;

WatchedBoard::WatchedBoard(Board& board) : board_(board) {
    board_.listen(
        [this](int usart, uint8_t byte, uint64_t time_us) { received(usart, byte, time_us); });
}

WatchedBoard::WatchedBoard(std::unique_ptr<Board> board) : WatchedBoard(*board) {
    owned_ = std::move(board);
}

bool WatchedBoard::runUntil(uint64_t time_us) {
    while (board_.time_us() < time_us) {
        const uint64_t frame_us = (board_.time_us() / kFrame_us + 1) * kFrame_us;
        if (!board_.runUntil(std::min(frame_us, time_us))) return false;
        if (board_.time_us() >= frame_us) look();
    }
    return true;
}

void WatchedBoard::look() {
    World& world = board_.world();
    invariants::Snapshot now;
    now.time_us = board_.time_us();
    now.truth = world.truth();
    for (int i = 0; i < 8; ++i) now.servo_us[static_cast<size_t>(i)] = world.servoPulse_us(i + 1);
    now.stick_us = world.radio().sticks();
    now.transmitting = world.radio().heard();
    const double now_s = now.time_s();
    for (const Fault& fault : world.faults())
        if (now_s >= fault.from_s && now_s < fault.to_s)
            now.faulty[static_cast<size_t>(fault.sensor)] = true;
    now.wide = world.faultOf(Faulty::radio) == FaultKind::wide;
    now.nine_channels = world.faultOf(Faulty::radio) == FaultKind::nine_channels;
    now.restarts = board_.restarts();
    now.begun_us = board_.begun_us();
    watch_.frame(now);
}

// A board sends the same on each of its links: the first on which it was heard is listened to, and
// another when that has fallen silent.
void WatchedBoard::received(int usart, uint8_t byte, uint64_t time_us) {
    constexpr uint64_t kSilent_us = 3'000'000;
    if (usart >= 0 && usart < kUsarts) {
        const auto port = static_cast<size_t>(usart);
        auto& parser = down_[port];
        for (bool whole = parser.put(byte); whole; whole = parser.next()) {
            const mavlink::Frame frame = parser.frame();
            heard_us_[port] = time_us;
            parameters_set_.received(frame);
            if (link_ < 0 || heard_us_[static_cast<size_t>(link_)] + kSilent_us < time_us)
                link_ = usart;
            const bool answer = frame.id == mavlink::Wire<mavlink::ParamValue>::id ||
                                frame.id == mavlink::Wire<mavlink::MissionAck>::id;
            if (usart == link_ || answer)
                watch_.received(frame, static_cast<double>(time_us) * 1e-6);
        }
    }
    if (listener_) listener_(usart, byte, time_us);
}

// As a rule a call is a frame. In noise before it another parser than the board's may see the
// beginning of a longer one, and wait for its end.
void WatchedBoard::send(int usart, const uint8_t* bytes, size_t size) {
    if (usart >= 0 && usart < kUsarts) {
        mavlink::PeerParser anew;
        if (sent(anew, bytes, size) == 0) sent(up_[static_cast<size_t>(usart)], bytes, size);
    }
    board_.send(usart, bytes, size);
}

// How many frames.
unsigned WatchedBoard::sent(mavlink::PeerParser& parser, const uint8_t* bytes, size_t size) {
    unsigned frames = 0;
    for (size_t i = 0; i < size; ++i)
        for (bool whole = parser.put(bytes[i]); whole; whole = parser.next(), ++frames) {
            watch_.sent(parser.frame(), static_cast<double>(board_.time_us()) * 1e-6);
            parameters_set_.sent(parser.frame());
        }
    return frames;
}

void WatchedBoard::reset() {
    watch_.provokedRestart(false);
    board_.reset();
}

std::string WatchedBoard::flash(const std::string& firmware) {
    watch_.provokedRestart(false);
    return board_.flash(firmware);
}

const std::vector<invariants::Violation>& WatchedBoard::violations() {
    watch_.end(board_.figures());
    return watch_.violations();
}

bool WatchedBoard::held() {
    for (const invariants::Violation& each : violations())
        std::printf("  VIOLATED  %s\n", each.line().c_str());
    return violations().empty();
}

}  // namespace simulator
