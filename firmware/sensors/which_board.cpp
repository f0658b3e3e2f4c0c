// SPDX-License-Identifier: GPL-3.0-or-later
// The boards have the same chip, but at PB0, a chip select of SPI0 on both, an APM 2 has its
// MPU-6000 and an APM 1 its DataFlash. Both are asked who they are. One that is silent, on the
// right board, does not make it the wrong one: only the other's answer does.
#include "board.hpp"
#include "core/file_state.hpp"
#include "core/rom.hpp"
#include "firmware/sensors/sensors.hpp"

namespace firmware {
namespace sensors {

namespace {

struct Chip {
    uint8_t question, answer;
};
constexpr Chip kChips[] ROM = {
    {0x9F, 0x1F},  // the DataFlash: who made it (data sheet 3500, 10.1)
    {0xF5, 0x68},  // the MPU-6000: its register 117
};

// The DataFlash answers 20 ms after power-on, the MPU-6000 after 100 at the latest
// (PS-MPU-6000A 6.3, start-up time for register access); a question takes 40 us at least. No output
// is driven before.
constexpr uint16_t kTries = 2500;

struct Board {
    bool wrong;
};
core::FileState<Board> found{};

bool isThere(uint8_t model) {
    const Chip chip = core::romRead(kChips[model - 1]);
    const board::ProbeBus::Lock lock;
    board::ProbeBus::slow();
    board::ProbeSelect::low();
    board::ProbeBus::transfer(chip.question);
    const uint8_t answer = board::ProbeBus::transfer(0);
    board::ProbeSelect::high();
    board::ProbeBus::fast();
    return answer == chip.answer;
}

}  // namespace

bool wrongBoard() { return found.wrong; }

void findBoard() {
    found.wrong = false;
    for (uint16_t i = 0; i < kTries && !found.wrong; ++i) {
        if (isThere(board::kModel)) return;
        found.wrong = isThere(3 - board::kModel);
    }
}

}  // namespace sensors
}  // namespace firmware
