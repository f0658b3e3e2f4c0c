// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/devices/supply.hpp"

#include <algorithm>
#include <cmath>

namespace simulator {
namespace {

constexpr double kRise_v_per_us = Supply::kNominal_v / 1000;

double fallen(const Sag& sag, uint64_t since_us, double from_v) {
    if (since_us >= sag.fall_us) return sag.volts;
    const double part = static_cast<double>(since_us) / static_cast<double>(sag.fall_us);
    return from_v - (from_v - sag.volts) * part;
}

double deepest(const Sag& sag, double from_v) {
    return fallen(sag, sag.to_us - sag.from_us, from_v);
}

double voltsOf(const Sag& sag, uint64_t now_us, double from_v) {
    if (now_us < sag.from_us) return from_v;
    if (now_us < sag.to_us) return fallen(sag, now_us - sag.from_us, from_v);
    const double risen = static_cast<double>(now_us - sag.to_us) * kRise_v_per_us;
    return std::min(from_v, deepest(sag, from_v) + risen);
}

struct Interval {
    uint64_t from_us, to_us;
};

std::optional<Interval> intervalBelow(const Sag& sag, double level_v, double from_v) {
    if (deepest(sag, from_v) >= level_v) return std::nullopt;
    const double part = (from_v - level_v) / (from_v - sag.volts);
    const auto down_us = static_cast<uint64_t>(static_cast<double>(sag.fall_us) * part);
    const double up_us = std::ceil((level_v - deepest(sag, from_v)) / kRise_v_per_us);
    return Interval{sag.from_us + down_us, sag.to_us + static_cast<uint64_t>(up_us)};
}

}  // namespace

double Supply::volts(uint64_t now_us) const {
    double least = level_v_;
    for (const Sag& sag : sags_) least = std::min(least, voltsOf(sag, now_us, level_v_));
    return least;
}

bool Supply::below(double level_v, uint64_t now_us) const {
    return std::any_of(sags_.begin(), sags_.end(), [&](const Sag& sag) {
        const auto low = intervalBelow(sag, level_v, level_v_);
        return low && now_us >= low->from_us && now_us < low->to_us;
    });
}

uint64_t Supply::nextCrossing_us(double level_v, uint64_t now_us) const {
    uint64_t next_us = UINT64_MAX;
    for (const Sag& sag : sags_) {
        const auto low = intervalBelow(sag, level_v, level_v_);
        if (!low) continue;
        for (const uint64_t at_us : {low->from_us, low->to_us})
            if (at_us > now_us) next_us = std::min(next_us, at_us);
    }
    return next_us;
}

uint64_t PoweredParts::nextEvent_us(uint64_t now_us) const {
    uint64_t next_us = UINT64_MAX;
    for (const Part& part : parts_)
        next_us = std::min(next_us, supply_.nextCrossing_us(part.least_v, now_us));
    return next_us;
}

void PoweredParts::run(uint64_t now_us) {
    for (Part& part : parts_) {
        const bool on = !supply_.below(part.least_v, now_us);
        if (on == part.on) continue;
        part.on = on;
        part.change(on, now_us);
    }
}

}  // namespace simulator
