// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/orientation.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

struct Turned {
    int roll_deg, pitch_deg, yaw_deg;
};
// MAV_SENSOR_ORIENTATION of MAVLink's common.xml, 0 to 37, by the names of its entries.
constexpr Turned kNames[drivers::kOrientations] = {
    {0, 0, 0},     {0, 0, 45},    {0, 0, 90},    {0, 0, 135},   {0, 0, 180},   {0, 0, 225},
    {0, 0, 270},   {0, 0, 315},   {180, 0, 0},   {180, 0, 45},  {180, 0, 90},  {180, 0, 135},
    {0, 180, 0},   {180, 0, 225}, {180, 0, 270}, {180, 0, 315}, {90, 0, 0},    {90, 0, 45},
    {90, 0, 90},   {90, 0, 135},  {270, 0, 0},   {270, 0, 45},  {270, 0, 90},  {270, 0, 135},
    {0, 90, 0},    {0, 270, 0},   {0, 180, 90},  {0, 180, 270}, {90, 90, 0},   {180, 90, 0},
    {270, 90, 0},  {90, 180, 0},  {270, 180, 0}, {90, 270, 0},  {180, 270, 0}, {270, 270, 0},
    {90, 180, 90}, {90, 0, 270},
};

// The rotation by Euler angles, yaw times pitch times roll, as textbooks have it.
core::Vector3 byTheBook(const Turned& turned, const core::Vector3& v) {
    constexpr double kRadians = 3.14159265358979 / 180;
    const double cr = std::cos(turned.roll_deg * kRadians),
                 sr = std::sin(turned.roll_deg * kRadians);
    const double cp = std::cos(turned.pitch_deg * kRadians),
                 sp = std::sin(turned.pitch_deg * kRadians);
    const double cy = std::cos(turned.yaw_deg * kRadians), sy = std::sin(turned.yaw_deg * kRadians);
    const double x = static_cast<double>(v.x), y = static_cast<double>(v.y),
                 z = static_cast<double>(v.z);
    return {static_cast<float>(cp * cy * x + (sr * sp * cy - cr * sy) * y +
                               (cr * sp * cy + sr * sy) * z),
            static_cast<float>(cp * sy * x + (sr * sp * sy + cr * cy) * y +
                               (cr * sp * sy - sr * cy) * z),
            static_cast<float>(-sp * x + sr * cp * y + cr * cp * z)};
}

TEST(Orientation, turns_as_the_names_of_mavlink_say) {
    const core::Vector3 measured = {100, 20, 3};
    for (uint8_t i = 0; i < drivers::kOrientations; ++i) {
        const core::Vector3 is = drivers::fromMounting(measured, i);
        const core::Vector3 wanted = byTheBook(kNames[i], measured);
        EXPECT_NEAR(is.x, wanted.x, 1e-4f) << int{i};
        EXPECT_NEAR(is.y, wanted.y, 1e-4f) << int{i};
        EXPECT_NEAR(is.z, wanted.z, 1e-4f) << int{i};
    }
}

TEST(Orientation, leaves_as_it_is_what_it_does_not_know) {
    const core::Vector3 is = drivers::fromMounting({1, 2, 3}, drivers::kOrientations);
    EXPECT_EQ(is.x, 1);
    EXPECT_EQ(is.y, 2);
    EXPECT_EQ(is.z, 3);
}

}  // namespace
