// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers that are the same on every computer (the standard's distributions are not).
#pragma once
#include <cstdint>
#include <random>
#include <vector>

namespace simulator::chaos {

class Dice {
public:
    explicit Dice(uint64_t seed) : engine_(seed) {}

    // Of 0 .. below-1.
    uint64_t below(uint64_t limit) { return engine_() % limit; }
    int whole(int from, int to) {
        return from + static_cast<int>(below(static_cast<uint64_t>(to - from + 1)));
    }
    double between(double from, double to) {
        return from + (to - from) * static_cast<double>(engine_() >> 11) * 0x1p-53;
    }
    bool chance(double share) { return between(0, 1) < share; }
    template <class Value>
    const Value& of(const std::vector<Value>& values) {
        return values[below(values.size())];
    }

private:
    std::mt19937_64 engine_;
};

}  // namespace simulator::chaos
