// SPDX-License-Identifier: GPL-3.0-or-later
// A chip running one of the programs of this folder, and what the tests feed it by the cycle. At
// the end of every test each interrupt must have kept within the 40 us that are promised.
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host_tests/chip/machine/machine.hpp"

class Bench : public Machine {
public:
    explicit Bench(const std::string& name) : Machine("hal_" + name) {}
    ~Bench() {
        constexpr uint32_t kLongest = 40 * 16;
        for (int vector = 1; vector < simulator::Interrupts::kVectors; ++vector) {
            EXPECT_LE(chip.interrupts().count(vector).max_cycles, kLongest) << "vector " << vector;
        }
    }

    // Runs until the program reports this number, again if it has before.
    Report runTo(int number, double at_most_ms = 1000) {
        const size_t seen = reports.size();
        const uint64_t end = chip.cycle() + static_cast<uint64_t>(at_most_ms * 16000);
        while (chip.cycle() < end && chip.run(chip.cycle() + 100)) {
            for (size_t i = seen; i < reports.size(); ++i) {
                if (reports[i].number == number) return reports[i];
            }
        }
        ADD_FAILURE() << "the program does not report " << number << ' ' << chip.fault();
        return {};
    }

    // All values reported under this number, in order.
    std::vector<int> words(int number) const {
        std::vector<int> all;
        for (const Report& each : reports) {
            if (each.number == number) all.push_back(each.word());
        }
        return all;
    }

    uint32_t longest(int vector) const { return chip.interrupts().count(vector).max_cycles; }
};
