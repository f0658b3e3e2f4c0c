// SPDX-License-Identifier: GPL-3.0-or-later
// Who looks on while the fly program flies: the live page, FlightGear, both or nobody.
#pragma once
#include <memory>

#include "simulator/fly_options.hpp"
#include "simulator/live/flightgear.hpp"
#include "simulator/live/live.hpp"
#include "simulator/parameter_file.hpp"
#include "simulator/report/summary.hpp"

namespace simulator {

std::string dateNow();  // ISO 8601, UTC, to the second

class FlyWatchers {
public:
    // `usart`: where the page's ground station is. Throws TcpError, UdpError.
    FlyWatchers(const FlyOptions& options, Board& board, int usart,
                const ParameterSettings& settings);

    live::Live* live() { return live_.get(); }  // nullptr: none
    std::string address() const;                // of the page; empty: none

    void receive(int usart, uint8_t byte, uint64_t time_us);
    // Until the step is due; at once where nobody waits for real time. False: `stop` says so.
    bool awaitStep(uint64_t until_us, const std::function<bool()>& stop);
    void step();
    // The faults and winds that were given on the way become events of the summary.
    void end(const std::string& why, Summary& summary);

private:
    Board& board_;
    std::unique_ptr<live::Live> live_;
    std::unique_ptr<live::FlightGear> flightgear_;
};

}  // namespace simulator
