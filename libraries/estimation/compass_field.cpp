// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/compass_field.hpp"
#include "core/seldom.hpp"

namespace estimation {
namespace {

constexpr float kOwn_s = 30.0f;
constexpr float kEarth_s = 25.0f;
constexpr float kMaxOwn_mg = 300.0f;

SELDOM void addLimited(float& own_mg, float step_mg) {
    own_mg = core::limit(own_mg + step_mg, -kMaxOwn_mg, kMaxOwn_mg);
}

}  // namespace

void CompassField::start(float horizontal_mg, float down_mg) {
    horizontal_mg_ = horizontal_mg;
    down_mg_ = down_mg;
}

core::Vector3 CompassField::unexpected(const core::Vector3& field_mg, float dt_s) {
    const core::Vector3 odd = {field_mg.x - horizontal_mg_, field_mg.y, field_mg.z - down_mg_};
    const float share = dt_s * (1.0f / kEarth_s);
    horizontal_mg_ += odd.x * share;
    down_mg_ += odd.z * share;
    return odd;
}

void CompassField::learn(const core::Vector3& odd_mg, float dt_s) {
    const float share = dt_s * (1.0f / kOwn_s);
    addLimited(own_mg_.x, odd_mg.x * share);
    addLimited(own_mg_.y, odd_mg.y * share);
    addLimited(own_mg_.z, odd_mg.z * share);
}

void CompassField::save(Known& known) const {
    const auto whole = [](float mg) { return static_cast<int16_t>(core::rounded(mg)); };
    known = {{whole(own_mg_.x), whole(own_mg_.y), whole(own_mg_.z)},
             whole(horizontal_mg_),
             whole(down_mg_)};
}

void CompassField::resume(const Known& known) {
    own_mg_ = {core::real(known.own[0]), core::real(known.own[1]), core::real(known.own[2])};
    start(core::real(known.horizontal), core::real(known.down));
}

}  // namespace estimation
