// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/random.hpp"

#include <cmath>

namespace simulator {
namespace {

constexpr uint64_t kGolden = 0x9E3779B97F4A7C15;

uint64_t mixed(uint64_t z) {
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return z ^ (z >> 31);
}

}  // namespace

Random::Random(uint64_t seed, uint64_t stream)
    : state_(mixed(seed + kGolden) ^ mixed(mixed(stream + 1))) {}

uint64_t Random::bits() { return mixed(state_ += kGolden); }

double Random::uniform() { return (static_cast<double>(bits() >> 11) + 0.5) * 0x1p-53; }

double Random::normal() {
    if (has_spare_) {
        has_spare_ = false;
        return spare_;
    }
    const double radius = std::sqrt(-2 * std::log(uniform()));
    const double angle = 2 * M_PI * uniform();
    spare_ = radius * std::sin(angle);
    has_spare_ = true;
    return radius * std::cos(angle);
}

Wander::Wander(double deviation, double correlation_s, Random& random)
    : deviation_(deviation), correlation_s_(correlation_s), value_(deviation * random.normal()) {}

double Wander::advance(double dt_s, Random& random) {
    const double decay = std::exp(-dt_s / correlation_s_);
    value_ = decay * value_ + deviation_ * std::sqrt(1 - decay * decay) * random.normal();
    return value_;
}

}  // namespace simulator
