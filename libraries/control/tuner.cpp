// SPDX-License-Identifier: GPL-3.0-or-later
#include "control/tuner.hpp"

#include "core/maths.hpp"

namespace control {
namespace {

constexpr core::BodyRate kBegins_rads(0.4f), kRest_rads(0.117f), kFastEnough_rads(0.303f),
    kSwing_rads(0.254f);
constexpr uint16_t kLongest = 400;  // frames
constexpr uint8_t kSwingLasts = 60, kMaxSwings = 6, kMaxTurnSwings = 3;
constexpr core::Ratio kFar(0.4f);

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

// A swing is a rate that comes back with the other sign soon, and moves the surface far: gusts
// swing a small airplane as fast, but the surface of gains that are right hardly moves then.
AxisTuner::Finding AxisTuner::swing(int16_t rate, int16_t surface) {
    if (since_ < kSwingLasts) ++since_;
    if (surface < low_) low_ = surface;
    if (surface > high_) high_ = surface;
    if (since_ == kSwingLasts) swings_ = 0;
    const int8_t side = rate > kSwing_rads.raw ? 1 : (rate < -kSwing_rads.raw ? -1 : 0);
    if (side == 0 || side == side_) return Finding::nothing;
    side_ = side;
    since_ = 0;
    const bool far = int32_t{high_} - low_ > kFar.raw;
    low_ = high_ = surface;
    if (!far) return Finding::nothing;
    if (++swings_ < kMaxSwings) return Finding::nothing;
    swings_ = 0;
    return Finding::shakes;
}

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
                                    core::BodyRate rate_rads) {
    const int16_t rate = rate_rads.raw;
    const bool rests = size(rate) < kRest_rads.raw;
    if (frames_ == 0) {
        const int16_t begins = core::limit<int16_t>(kBegins_rads.raw, 0, gains.most_up_rads.raw);
        if (size(demand_rads.raw) < begins) return swing(rate, surface(state).raw);
        if (!rests || air.integrators_rest) return Finding::nothing;
        used_ = expected_ = 0;
        fastest_rads_.raw = 0;
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
