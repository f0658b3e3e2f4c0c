// SPDX-License-Identifier: GPL-3.0-or-later
// A board for ground stations: its serial lines as TCP ports, at real time or in lock step.
//
// Lock step, a text protocol on a third port (base + 2), one line each way; emulated time stands
// still but for what is granted:
//   advance MS [BYTES0 [BYTES1]]   runs MS milliseconds, then answers "at MS BYTES0 BYTES1": the
//                                  time since power-on and how many bytes have been sent so far
//                                  on the base port and on base + 1. The optional counts say how
//                                  many bytes the client has written there so far; the run waits
//                                  (for at most 5 s of real time) until they have come.
//   state                          answers one line of JSON: the truth of this moment
//   sticks P1 ... P8 | sticks off  the transmitter's pulses in us, or switched off; answers "ok"
//   usb in | usb out               the USB sense pin PA1; answers "ok"
//   launch                         throws an airplane that has no wheels; answers "ok"
//   servos                         answers one line of JSON: the last pulse of each output in us, 0
//                                  where there is none
//   load                           answers the share of the processor's cycles since power-on in
//                                  which it did not sleep, 0 to 1; not natively
//   reset                          presses the reset button; answers "ok"
//   fault PART:HOW SECONDS         fails from now on for so long (simulator/devices/faults.hpp);
//                                  "fault none" ends all; answers "ok"
//   gps KIND BAUD                  plugs another receiver in; answers "ok"
//   flash FILE                     another image instead of the one in the flash, then a reset;
//                                  answers "ok"
// and with --bench, angles and rates in degrees:
//   turn-to ROLL PITCH YAW | turn ROLL PITCH YAW | lift METRES | blow MPS | supply VOLTS
// Anything else is answered "error: ...".
#pragma once
#include <array>
#include <functional>
#include <string>

#include "simulator/board.hpp"
#include "simulator/ground/tcp_port.hpp"

namespace simulator {

class Server {
public:
    static constexpr int kLines = 2;

    // `usarts`: which USART stands behind the base port and behind base + 1.
    Server(Board& board, uint16_t base, std::array<int, kLines> usarts, bool lock_step);

    uint16_t port() const { return lines_[0].tcp.port(); }
    uint16_t secondPort() const { return lines_[1].tcp.port(); }
    uint16_t controlPort() const { return control_->port(); }

    // For the board's listener; sent on when the present step ends.
    void fromBoard(int usart, uint8_t byte);

    size_t clients() const { return lines_[0].tcp.clients() + lines_[1].tcp.clients(); }

    // Steps of 10 ms, each when `await` has returned true, `stepped` behind it; until it returns
    // false or the board cannot go on.
    void run(const std::function<bool(uint64_t until_us)>& await,
             const std::function<void()>& stepped);
    // Until `stop` says so or the board cannot go on.
    void runLockStep(const std::function<bool()>& stop);

private:
    struct Line {
        Line(uint16_t port, int number) : tcp(port), usart(number) {}
        TcpPort tcp;
        int usart;
        std::vector<uint8_t> from_board;
        uint64_t in = 0, out = 0;  // bytes so far
    };

    void takeInput();
    void giveOutput();
    bool advance(uint64_t until_us);
    std::string answer(const std::string& line);
    std::string answerAdvance(const std::string& rest);
    std::string answerSticks(const std::string& rest);
    std::string answerServos();
    std::string answerLoad();
    std::string answerFault(const std::string& rest);
    std::string answerGps(const std::string& rest);
    std::string answerFlash(const std::string& rest);
    std::string answerSupply(double volts);
    std::string answerHands(const std::string& verb, const std::string& rest);
    void awaitInput(const std::array<uint64_t, kLines>& wanted);
    std::vector<TcpPort*> ports();

    Board& board_;
    std::function<bool()> stop_ = [] { return false; };
    std::array<Line, kLines> lines_;
    std::unique_ptr<TcpPort> control_;
    std::string command_;      // a line not yet whole
    uint64_t granted_us_ = 0;  // the sum of what was granted
};

std::string truthJson(const Truth& truth);

}  // namespace simulator
