// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/compass_field.hpp"

namespace estimation {
namespace {

constexpr float kOwn_s = 10.0f;
constexpr float kEarth_s = 40.0f;
constexpr float kMostOwn_mg = 300.0f;

}  // namespace

void CompassField::start(float horizontal_mg, float down_mg) {
    horizontal_mg_ = horizontal_mg;
    down_mg_ = down_mg;
}

void CompassField::learn(const core::Vector3& field_mg, const core::Vector3& north,
                         const core::Vector3& east, const core::Vector3& down, float dt_s) {
    const core::Vector3 odd = {field_mg.x - horizontal_mg_, field_mg.y, field_mg.z - down_mg_};
    horizontal_mg_ += odd.x * (dt_s / kEarth_s);
    down_mg_ += odd.z * (dt_s / kEarth_s);
    const core::Vector3 body = north * odd.x + east * odd.y + down * odd.z;
    own_mg_ = own_mg_ + body * (dt_s / kOwn_s);
    own_mg_ = {core::limit(own_mg_.x, -kMostOwn_mg, kMostOwn_mg),
               core::limit(own_mg_.y, -kMostOwn_mg, kMostOwn_mg),
               core::limit(own_mg_.z, -kMostOwn_mg, kMostOwn_mg)};
}

}  // namespace estimation
