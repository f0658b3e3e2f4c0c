// SPDX-License-Identifier: GPL-3.0-or-later
// A board whose flight is held to the invariants: it runs as the board it is made around, and looks
// at it after every frame.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "mavlink/peer.hpp"
#include "simulator/board.hpp"
#include "simulator/ground/parameters_set.hpp"
#include "simulator/invariants/watch.hpp"

namespace simulator {

class WatchedBoard : public Board {
public:
    // Does not own `board`.
    explicit WatchedBoard(Board& board);
    explicit WatchedBoard(std::unique_ptr<Board> board);

    bool runUntil(uint64_t time_us) override;
    uint64_t time_us() const override { return board_.time_us(); }
    std::string fault() const override { return board_.fault(); }
    void listen(Listener listener) override { listener_ = std::move(listener); }
    void send(int usart, const uint8_t* bytes, size_t size) override;
    size_t unsent(int usart) const override { return board_.unsent(usart); }
    void setUsb(bool plugged) override { board_.setUsb(plugged); }
    void reset() override;
    std::string flash(const std::string& firmware) override;
    void expectRestart() override { watch_.provokedRestart(false); }
    std::vector<uint8_t> eeprom() const override { return board_.eeprom(); }
    void setEeprom(const std::vector<uint8_t>& image) override { board_.setEeprom(image); }
    World& world() override { return board_.world(); }
    BoardFigures figures() const override { return board_.figures(); }
    std::optional<uint32_t> lastFrame_us() const override { return board_.lastFrame_us(); }
    unsigned restarts() const override { return board_.restarts(); }
    uint64_t begun_us() const override { return board_.begun_us(); }
    void closeTrace() override { board_.closeTrace(); }
    void closeProfile() override { board_.closeProfile(); }

    invariants::Watch& watch() { return watch_; }
    // So far, with what only shows at the end.
    const std::vector<invariants::Violation>& violations();
    // Prints them; true when there are none.
    bool held();
    // By whatever has sent PARAM_SET on any of its ports.
    const ParametersSet& parametersSet() const { return parameters_set_; }

private:
    void look();
    unsigned sent(mavlink::PeerParser& parser, const uint8_t* bytes, size_t size);
    void received(int usart, uint8_t byte, uint64_t time_us);

    static constexpr int kUsarts = 4;
    std::unique_ptr<Board> owned_;
    Board& board_;
    Listener listener_;
    invariants::Watch watch_;
    ParametersSet parameters_set_;
    std::array<mavlink::PeerParser, kUsarts> down_, up_;
    std::array<uint64_t, kUsarts> heard_us_{};
    int link_ = -1;  // the one that is listened to: where a heartbeat came first
};

}  // namespace simulator
