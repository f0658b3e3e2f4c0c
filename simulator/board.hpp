// SPDX-License-Identifier: GPL-3.0-or-later
// A board with firmware on it, as the programs around it see it: the emulated chip with an image
// in its flash, or the same firmware compiled for this computer.
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "simulator/world.hpp"

namespace simulator {

// What only the emulated chip can measure; empty where the board or the firmware does not report
// it.
struct BoardFigures {
    std::optional<double> cpu_load;        // 0..1, cycles not asleep
    std::optional<double> interrupt_load;  // 0..1
    std::optional<uint32_t> frames;
    std::optional<uint32_t> frame_max_us, frame_mean_us, frame_p99_us;
    // from the data-ready edge of the newest inertial sample a frame uses to its last servo write
    std::optional<uint32_t> latency_mean_us, latency_max_us;
    std::optional<uint32_t> frame_overruns;  // frames not done before the next was due
    std::optional<uint32_t> flash_bytes, ram_static_bytes, stack_max_bytes;
    struct Task {
        int number;
        uint32_t runs;
        uint32_t max_cycles;
        double mean_cycles;
    };
    std::vector<Task> tasks;
    struct Interrupt {
        int vector;
        uint64_t runs;
        uint32_t max_cycles;
        uint64_t cycles;
    };
    std::vector<Interrupt> interrupts;
};

class Board {
public:
    virtual ~Board() = default;

    // Runs until emulated time `time_us` (since power-on). False: the firmware can not go on;
    // why is in fault().
    virtual bool runUntil(uint64_t time_us) = 0;
    virtual uint64_t time_us() const = 0;
    virtual std::string fault() const = 0;

    // Serial lines by USART number. Bytes given to send() reach the board at its line's rate;
    // everything the board sends goes to the listener with its time.
    using Listener = std::function<void(int usart, uint8_t byte, uint64_t time_us)>;
    virtual void listen(Listener listener) = 0;
    virtual void send(int usart, const uint8_t* bytes, size_t size) = 0;
    virtual size_t unsent(int usart) const = 0;  // bytes still waiting for the line
    virtual void setUsb(bool plugged) = 0;       // PA1 low when plugged

    virtual void reset() = 0;        // the reset button
    virtual void expectRestart() {}  // the supply is going to make one
    // Another image instead of the one that is in the flash, then a reset; what is wrong with it.
    virtual std::string flash(const std::string&) { return "this board has no flash"; }
    // Of the processor since power-on, whatever made it; and when the program's first instruction
    // last ran.
    virtual unsigned restarts() const { return 0; }
    virtual uint64_t begun_us() const { return 0; }
    virtual std::vector<uint8_t> eeprom() const = 0;
    virtual void setEeprom(const std::vector<uint8_t>& image) = 0;  // before the first runUntil
    virtual World& world() = 0;
    virtual BoardFigures figures() const = 0;
    // Busy share and length of the newest whole frame, for a time series; empty when unknown.
    virtual std::optional<uint32_t> lastFrame_us() const { return std::nullopt; }
    // The files that were asked for of this board; throw OutputError when they are not whole.
    virtual void closeTrace() {}
    virtual void closeProfile() {}
};

}  // namespace simulator
