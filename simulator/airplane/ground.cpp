// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/airplane/ground.hpp"

#include <algorithm>

#include "simulator/airplane/atmosphere.hpp"
#include "simulator/constants.hpp"

namespace simulator {
namespace {

constexpr double kFirm_m = 0.005;  // the damper grips gradually over this depth

}  // namespace

struct Ground::Touch {
    Vec3 place_m;        // on the ground
    Vec3 arm_m;          // earth axes, from the centre of gravity
    Vec3 along, across;  // rolling direction and the other, level
    double normal_n, sink_mps;
    double slip_along_m, slip_across_m;  // from the anchor
    double along_n, across_n;            // friction
    double most_along_n, most_across_n;
};

Ground::Ground(const AirplaneParameters& p) : p_(p), anchors_(p.contacts.size()) {
    for (const Contact& contact : p.contacts)
        reach_m_ = std::max(reach_m_, length(contact.place_m));
}

double Ground::standingHeight_m() const {
    const bool wheels = std::any_of(p_.contacts.begin(), p_.contacts.end(),
                                    [](const Contact& contact) { return contact.wheel; });
    double stiffness = 0, lowest_m = 0;
    for (const Contact& contact : p_.contacts) {
        if (wheels && !contact.wheel) continue;
        stiffness += contact.stiffness_nm;
        lowest_m = std::max(lowest_m, contact.place_m.z);
    }
    return lowest_m - p_.mass_kg * kGravity_mss / stiffness;
}

bool Ground::touch(size_t index, const Motion& motion, const Rotation& rotation, double rudder,
                   Touch& out) const {
    const Contact& contact = p_.contacts[index];
    out.arm_m = rotation.toEarth(contact.place_m);
    out.place_m = motion.position_m + out.arm_m;
    const double depth_m = out.place_m.z;
    if (depth_m <= 0) return false;
    const Vec3 velocity =
        motion.velocity_mps + rotation.toEarth(cross(motion.rates_rads, contact.place_m));
    out.sink_mps = velocity.z;
    const double damping = contact.damping_nsm * std::min(1.0, depth_m / kFirm_m);
    out.normal_n = std::max(0.0, contact.stiffness_nm * depth_m + damping * velocity.z);

    const double steer = contact.steered ? rudder * p_.controls.nose_wheel_deg * kRadians : 0;
    const Vec3 ahead =
        rotation.toEarth(steer == 0 ? Vec3{1, 0, 0} : Vec3{std::cos(steer), std::sin(steer), 0});
    const double level = std::max(1e-6, std::sqrt(ahead.x * ahead.x + ahead.y * ahead.y));
    out.along = {ahead.x / level, ahead.y / level, 0};
    out.across = {-out.along.y, out.along.x, 0};

    const Vec3 slip = out.place_m - anchors_[index];
    const auto held = [this](double slip_m, double speed_mps, double most_n) {
        return std::clamp(-p_.grip.stiffness_nm * slip_m - p_.grip.damping_nsm * speed_mps, -most_n,
                          most_n);
    };
    out.slip_along_m = dot(slip, out.along);
    out.slip_across_m = dot(slip, out.across);
    out.most_along_n = contact.rolling * out.normal_n;
    out.most_across_n = contact.sliding * out.normal_n;
    out.along_n = held(out.slip_along_m, dot(velocity, out.along), out.most_along_n);
    out.across_n = held(out.slip_across_m, dot(velocity, out.across), out.most_across_n);
    return true;
}

Loads Ground::loads(const Motion& motion, double rudder) const {
    Loads sum{};
    if (-motion.position_m.z > reach_m_) return sum;
    const Rotation rotation(motion.attitude);
    Touch t;
    for (size_t i = 0; i < anchors_.size(); ++i) {
        if (!touch(i, motion, rotation, rudder, t)) continue;
        const Vec3 force = t.along * t.along_n + t.across * t.across_n + Vec3{0, 0, -t.normal_n};
        sum.force_n += rotation.toBody(force);
        sum.moment_nm += rotation.toBody(cross(t.arm_m, force));
    }
    return sum;
}

void Ground::advance(const Motion& motion, double rudder) {
    touching_ = false;
    if (-motion.position_m.z > reach_m_) return;
    const Rotation rotation(motion.attitude);
    Touch t;
    for (size_t i = 0; i < anchors_.size(); ++i) {
        if (!touch(i, motion, rotation, rudder, t)) {
            anchors_[i] = {t.place_m.x, t.place_m.y, 0};
            continue;
        }
        touching_ = true;
        if (t.sink_mps > p_.contacts[i].breaks_at_mps) broken_ = true;
        const double k = p_.grip.stiffness_nm;
        const double along = std::clamp(t.slip_along_m, -t.most_along_n / k, t.most_along_n / k);
        const double across =
            std::clamp(t.slip_across_m, -t.most_across_n / k, t.most_across_n / k);
        const Vec3 anchor = t.place_m - t.along * along - t.across * across;
        anchors_[i] = {anchor.x, anchor.y, 0};
    }
}

}  // namespace simulator
