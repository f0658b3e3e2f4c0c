// SPDX-License-Identifier: GPL-3.0-or-later
// A chip running one of the programs of this folder, which reports by writing GPIOR0: each report
// keeps the cycle and what stood in GPIOR1 and GPIOR2.
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "simulator/machine/chip.hpp"

inline std::string program(const std::string& file) {
    return std::string(CHIP_PROGRAMS) + "/" + file;
}

struct Report {
    int number;
    uint64_t cycle;
    int low, high;  // GPIOR1, GPIOR2
    int word() const { return low | high << 8; }
};

class Machine {
public:
    explicit Machine(const std::string& name) : chip(simulator::readImage(program(name + ".elf"))) {
        chip.on_trace = [this](uint8_t value) {
            const uint8_t* data = chip.avr()->data;
            reports.push_back(
                {value, chip.cycle(), data[simulator::kGpior1], data[simulator::kGpior2]});
        };
    }

    void boot(const std::string& board) {
        chip.setBootSection(simulator::readImage(std::string(SIMULATOR_BOOT "/") + board + ".elf"));
    }
    void run_ms(double ms) {
        ASSERT_TRUE(chip.run(chip.cycle() + static_cast<uint64_t>(ms * 16000))) << chip.fault();
    }
    // The first report of this number; fails the test when there is none.
    Report report(int number) const {
        for (const Report& each : reports)
            if (each.number == number) return each;
        ADD_FAILURE() << "the program has not reported " << number;
        return {};
    }
    int64_t cyclesBetween(int from, int to) const {
        return static_cast<int64_t>(report(to).cycle - report(from).cycle);
    }

    simulator::Chip chip;
    std::vector<Report> reports;
};
