// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers that are the same bits for the same seed, one independent stream per user.
// Generator: splitmix64 (Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators).
#pragma once
#include <cstdint>

namespace simulator {

class Random {
public:
    explicit Random(uint64_t seed, uint64_t stream = 0);

    uint64_t bits();
    double uniform();  // 0 < value < 1
    double normal();   // mean 0, standard deviation 1 (Box and Muller)

private:
    uint64_t state_;
    double spare_ = 0;
    bool has_spare_ = false;
};

// A first-order Gauss-Markov process: wanders about 0 with the given standard deviation and
// correlation time.
class Wander {
public:
    Wander(double deviation, double correlation_s, Random& random);

    double advance(double dt_s, Random& random);
    double value() const { return value_; }

private:
    double deviation_, correlation_s_, value_;
};

}  // namespace simulator
