// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine.hpp"

namespace {

// Raises and lowers the capture pin at given cycles, from a cycle timer as the board does.
struct Edges {
    simulator::Chip& chip;
    std::vector<uint64_t> rises;
    size_t next = 0;
    bool high = false;

    void start() { simulator::startTimerAt<&Edges::edge>(chip.avr(), rises[0], this); }
    uint64_t edge(uint64_t due) {
        high = !high;
        chip.drive('L', 1, high);
        chip.captureEdge('5', high, due);
        if (high) return due + 400 * 16;
        return ++next < rises.size() ? rises[next] : 0;
    }
};

}  // namespace

TEST(Capture, every_edge_is_stamped_with_its_exact_tick_in_mode_15) {
    Machine machine("capture");
    machine.run_ms(1);
    Edges edges{machine.chip, {}};
    for (uint64_t us = 1500, i = 0; i < 60; i++, us += 900 + 21 * i) edges.rises.push_back(us * 16);
    edges.start();
    machine.run_ms(120);

    std::vector<int> captured;
    for (const Report& each : machine.reports)
        if (each.number == 1) captured.push_back(each.word());
    ASSERT_EQ(captured.size(), edges.rises.size());
    for (size_t i = 1; i < captured.size(); i++) {
        const int ticks = (captured[i] - captured[i - 1] + 40000) % 40000;
        EXPECT_EQ(ticks, static_cast<int>((edges.rises[i] - edges.rises[i - 1]) / 8)) << i;
    }
}
