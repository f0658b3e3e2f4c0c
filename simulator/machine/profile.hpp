// SPDX-License-Identifier: GPL-3.0-or-later
// Where the cycles of a run went: by instruction, and by call with all that was called from there.
// What an interrupt takes counts for the interrupt, not for what it interrupted; sleep counts for
// nothing. toolchain/profile makes a table of it.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace simulator {

class Profile {
public:
    struct Step {  // one instruction has been executed, and perhaps an interrupt been entered
        uint32_t address, next;  // of flash, in bytes
        uint64_t cycles;         // without sleep
        uint16_t stack;          // afterwards
        bool interrupted;        // next is a vector's
        bool calls;              // the instruction was a call
    };
    explicit Profile(size_t flash_bytes) : cycles_(flash_bytes / 2) {}

    void add(const Step& step);
    void reset() { open_.clear(); }

    struct Program {
        std::string path, sha256;
    };
    // Addresses mean something in this program alone. The cycles are those asleep, too.
    std::string json(const Program& program, uint64_t all_cycles) const;

private:
    struct Open {  // a call or an interrupt that has not returned
        uint32_t from, to;
        uint16_t stack;
        uint64_t since;  // of its level's clock
        bool interrupt;
    };
    struct Call {
        uint64_t runs = 0, cycles = 0;
    };

    uint64_t& clock() { return clocks_[in_interrupts_ > 0]; }
    void returnFrom();

    std::vector<uint64_t> cycles_;  // by word of flash
    std::map<std::pair<uint32_t, uint32_t>, Call> calls_;
    std::vector<Open> open_;
    uint64_t clocks_[2] = {};  // of the program and of interrupts
    int in_interrupts_ = 0;
};

}  // namespace simulator
