// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/lights.hpp"

#include "board.hpp"
#include "core/rom.hpp"
#include "firmware/arming.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/vehicle.hpp"

namespace firmware {
namespace {

// One bit a tenth of a second, sixteen of them, over and over.
constexpr uint16_t kOff = 0x0000;
constexpr uint16_t kOn = 0xFFFF;
constexpr uint16_t kOneFlash = 0x0003;
constexpr uint16_t kTwoFlashes = 0x0033;
constexpr uint16_t kFast = 0x5555;
constexpr uint16_t kBetween = 0xAAAA;  // while what is kFast is dark
constexpr uint16_t kSlow = 0x3333;

enum class Light : uint8_t { a, b, c };  // red, yellow, blue

bool broken() { return wrongBoard() || !vehicle.imu.healthy; }
bool armed() { return vehicle.armed; }
bool gyrosUnknown() { return !vehicle.imu.calibrated; }
bool radioLost() { return vehicle.radio.lost; }
bool noGps() { return vehicle.gps.fix == GpsFix::no_gps; }
bool noFix() { return vehicle.gps.fix == GpsFix::none; }
bool flatFix() { return vehicle.gps.fix == GpsFix::two_d; }
bool always() { return true; }

struct Row {
    Light light;
    bool (*holds)();
    uint16_t pattern;
};

// Of each light the first row that holds.
// clang-format off
constexpr Row kRows[] ROM = {
    {Light::a, broken,       kFast},        // all three together
    {Light::a, armed,        kOn},
    {Light::a, gyrosUnknown, kFast},        // red and blue in turn: keep it still
    {Light::a, prearmOk,     kOneFlash},
    {Light::a, always,       kTwoFlashes},
    {Light::b, broken,       kFast},
    {Light::b, radioLost,    kTwoFlashes},
    {Light::b, always,       kOff},
    {Light::c, broken,       kFast},
    {Light::c, gyrosUnknown, kBetween},
    {Light::c, noGps,        kOff},
    {Light::c, noFix,        kFast},
    {Light::c, flatFix,      kSlow},
    {Light::c, always,       kOn},
};
// clang-format on

uint8_t tenth;

bool lit(Light light) {
    for (const Row& in_flash : kRows) {
        const Row row = core::romRead(in_flash);
        if (row.light == light && row.holds()) return (row.pattern >> tenth & 1) != 0;
    }
    return false;
}

template <class Led>
void show(Light light) {
    if (lit(light)) {
        Led::on();
    } else {
        Led::off();
    }
}

}  // namespace

void runLights() {
    tenth = (tenth + 1) % 16;
    show<board::LedA>(Light::a);
    show<board::LedB>(Light::b);
    show<board::LedC>(Light::c);
}

}  // namespace firmware
