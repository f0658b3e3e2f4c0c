// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/tuner.hpp"

#include "core/maths.hpp"

namespace control {
namespace {

constexpr core::BodyRate kBegins_rads(0.4f), kRest_rads(0.117f), kFastEnough_rads(0.303f);
constexpr uint16_t kLongest = 400;  // frames
constexpr uint8_t kMaxTurnSwings = 3;
constexpr Swing::Limits kSwings = {6, 90, 60};

constexpr int32_t kFull = AxisState::Output::kOne;

int16_t size(int16_t value) { return value < 0 ? static_cast<int16_t>(-value) : value; }

// As far as the surface goes.
core::Ratio surface(const AxisState& state) {
    const int32_t limited = core::limit(state.last_output.raw, -kFull, kFull);
    return core::Ratio::fromRaw(AxisState::Output{limited}.as<14>().raw);
}

int16_t expected(const AxisGains& gains, const AirFlow& air, int16_t rate) {
    const int32_t direct = core::product(gains.feed_forward.raw, rate) >> 8;
    return core::times14(core::narrowed(direct), air.speed_scale.raw);
}

}  // namespace

// Back and forth, each time nearly half as fast as the fastest: a turn under way ends so where the
// gains are too high, and neither its surface nor its rate says how strong the surface is.
bool AxisTuner::swingsOn(int16_t rate) {
    const int16_t fast = static_cast<int16_t>((fastest_rads_.raw >> 3) * 3);
    if (size(rate) < core::limit<int16_t>(fast, kFastEnough_rads.raw, INT16_MAX)) return false;
    const int8_t side = rate > 0 ? 1 : -1;
    if (side == side_) return false;
    side_ = side;
    return ++swings_ > kMaxTurnSwings;
}

AxisTuner::Finding AxisTuner::watch(const AxisGains& gains, const AxisState& state,
                                    const AirFlow& air, core::BodyRate demand_rads,
                                    core::BodyRate rate_rads, Swing& swing) {
    const int16_t rate = rate_rads.raw;
    const bool rests = size(rate) < kRest_rads.raw;
    if (frames_ == 0) {
        const int16_t begins = core::limit<int16_t>(kBegins_rads.raw, 0, gains.most_up_rads.raw);
        if (size(demand_rads.raw) < begins)
            return swing.watch(rate_rads, surface(state), kSwings) ? Finding::shakes
                                                                   : Finding::nothing;
        if (!rests || air.integrators_rest) return Finding::nothing;
        used_ = expected_ = 0;
        fastest_rads_.raw = 0;
        swing = Swing();
        swings_ = 0;
        side_ = 0;
        rest_.raw = static_cast<int16_t>(state.integrator.as<14>().raw);
    }
    used_ += int32_t{surface(state).raw} - rest_.raw;
    expected_ += expected(gains, air, rate);
    fastest_rads_.raw = core::limit<int16_t>(size(rate), fastest_rads_.raw, INT16_MAX);
    if (swingsOn(rate)) {
        frames_ = 0;
        return Finding::shakes;
    }
    const bool over = rests && fastest_rads_.raw >= kFastEnough_rads.raw;
    if (!over && ++frames_ < kLongest) return Finding::nothing;
    frames_ = 0;
    return over ? Finding::measured : Finding::nothing;
}

float AxisTuner::factor() const {
    if (expected_ == 0) return 1;
    return core::limit(static_cast<float>(used_) / static_cast<float>(expected_), kLeast, kMax);
}

}  // namespace control
