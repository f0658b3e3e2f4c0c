// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/servo_pulses.hpp"

namespace simulator {
namespace {

struct Wire {
    char port;
    int bit;
    char timer;
    int compare;
};
// Outputs 1..8 are OC1B, OC1A, OC4C, OC4B, OC4A, OC3C, OC3B, OC3A.
constexpr Wire kWires[ServoPulses::kOutputs] = {
    {'B', 6, '1', 1}, {'B', 5, '1', 0}, {'H', 5, '4', 2}, {'H', 4, '4', 1},
    {'H', 3, '4', 0}, {'E', 5, '3', 2}, {'E', 4, '3', 1}, {'E', 3, '3', 0},
};
// What stays high longer was no pulse: the output was taken from its timer meanwhile.
constexpr uint64_t kLongest = 10000 * kCyclesPer_us;

}  // namespace

ServoPulses::ServoPulses(Chip& chip) : chip_(chip) {
    for (int i = 0; i < kOutputs; i++)
        chip.onCompareOutput(kWires[i].timer, kWires[i].compare,
                             [this, i](bool high) { changed(i, high); });
}

void ServoPulses::changed(int index, bool high) {
    if (!chip_.isOutput(kWires[index].port, kWires[index].bit)) return;
    Level& level = levels_[index];
    const bool ended = level.high && !high;
    const uint64_t width = chip_.cycle() - level.since;
    level = {high, chip_.cycle()};
    if (on_level) on_level(index + 1, high);
    if (ended && width <= kLongest && on_pulse)
        on_pulse(index + 1, static_cast<double>(width) / kCyclesPer_us);
}

}  // namespace simulator
