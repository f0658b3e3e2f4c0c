// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors and rotations in space, in double precision. A Rotation turns body axes (x forward,
// y right, z down) into north, east, down.
#pragma once
#include <cmath>

namespace simulator {

struct Vec3 {
    double x = 0, y = 0, z = 0;
};
constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator*(const Vec3& a, double s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr Vec3& operator+=(Vec3& a, const Vec3& b) { return a = a + b; }
constexpr double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vec3& a) { return std::sqrt(dot(a, a)); }

struct Quaternion {
    double w = 1, x = 0, y = 0, z = 0;
};
constexpr Quaternion operator+(const Quaternion& a, const Quaternion& b) {
    return {a.w + b.w, a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Quaternion operator*(const Quaternion& a, double s) {
    return {a.w * s, a.x * s, a.y * s, a.z * s};
}
Quaternion quaternion(double roll_rad, double pitch_rad, double yaw_rad);
Quaternion normalized(const Quaternion& q);
// The rate of change of the attitude at these body rates.
constexpr Quaternion turning(const Quaternion& q, const Vec3& rates) {
    return Quaternion{-q.x * rates.x - q.y * rates.y - q.z * rates.z,
                      q.w * rates.x + q.y * rates.z - q.z * rates.y,
                      q.w * rates.y - q.x * rates.z + q.z * rates.x,
                      q.w * rates.z + q.x * rates.y - q.y * rates.x} *
           0.5;
}

class Rotation {
public:
    explicit constexpr Rotation(const Quaternion& q)
        : north_{1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y - q.w * q.z),
                 2 * (q.x * q.z + q.w * q.y)},
          east_{2 * (q.x * q.y + q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z),
                2 * (q.y * q.z - q.w * q.x)},
          down_{2 * (q.x * q.z - q.w * q.y), 2 * (q.y * q.z + q.w * q.x),
                1 - 2 * (q.x * q.x + q.y * q.y)} {}

    constexpr Vec3 toEarth(const Vec3& body) const {
        return {dot(north_, body), dot(east_, body), dot(down_, body)};
    }
    constexpr Vec3 toBody(const Vec3& earth) const {
        return north_ * earth.x + east_ * earth.y + down_ * earth.z;
    }
    double roll_rad() const { return std::atan2(down_.y, down_.z); }
    double pitch_rad() const { return std::asin(down_.x < -1 ? 1 : down_.x > 1 ? -1 : -down_.x); }
    double yaw_rad() const { return std::atan2(east_.x, north_.x); }

private:
    Vec3 north_, east_, down_;  // the earth's axes seen from the body
};

}  // namespace simulator
