// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/airplane/vector.hpp"

namespace simulator {

Quaternion quaternion(double roll_rad, double pitch_rad, double yaw_rad) {
    const double cr = std::cos(roll_rad / 2), sr = std::sin(roll_rad / 2);
    const double cp = std::cos(pitch_rad / 2), sp = std::sin(pitch_rad / 2);
    const double cy = std::cos(yaw_rad / 2), sy = std::sin(yaw_rad / 2);
    return {cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
            cr * cp * sy - sr * sp * cy};
}

Quaternion normalized(const Quaternion& q) {
    return q * (1 / std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z));
}

}  // namespace simulator
