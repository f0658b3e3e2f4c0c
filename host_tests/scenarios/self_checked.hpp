// SPDX-License-Identifier: GPL-3.0-or-later
// The frame of a flight that checks itself and is flown both by the image and natively: the board,
// the folders, the exit status.
#pragma once
#include <memory>

#include "host_tests/scenarios/flight_report.hpp"
#include "simulator/machine/apm2_board.hpp"
#include "simulator/native/native_board.hpp"

namespace simulator {

// A Flight has fly(), true when all was well, and summary(firmware, world). It is made of the board
// and what else is given.
template <class Flight, class... Rest>
int flyAndCheck(const std::string& firmware, const WorldOptions& world,
                const std::filesystem::path& out, const std::filesystem::path& minutes,
                const Rest&... rest) {
    emptyFolder(out);
    std::unique_ptr<Board> board;
    if (firmware == "native")
        board = std::make_unique<NativeBoard>(world);
    else
        board = std::make_unique<AvrBoard>(firmware, world);
    Flight flight(*board, rest...);
    const bool kept = flight.fly();
    writeOutcome(out, minutes, flight.summary(firmware, world));
    return kept ? 0 : 1;
}

}  // namespace simulator
