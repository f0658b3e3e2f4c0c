// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/actuators/lights.hpp"

#include "board.hpp"
#include "core/file_state.hpp"
#include "core/rom.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace actuators {

using namespace state;
using namespace sensors;

namespace {

// One bit a tenth of a second, sixteen of them, over and over.
constexpr uint16_t kOff = 0x0000;
constexpr uint16_t kOn = 0xFFFF;
constexpr uint16_t kOneFlash = 0x0003;
constexpr uint16_t kTwoFlashes = 0x0033;
constexpr uint16_t kFast = 0x5555;
constexpr uint16_t kBetween = 0xAAAA;  // while what is kFast is dark
constexpr uint16_t kSlow = 0x3333;

bool broken() { return wrongBoard() || !vehicle.imu.healthy; }
bool armed() { return vehicle.armed; }
bool gyrosUnknown() { return !vehicle.imu.calibrated; }
bool ready() { return vehicle.prearm_ok; }
bool radioLost() { return vehicle.radio.lost; }
bool noGps() { return vehicle.gps.fix == GpsFix::no_gps; }
bool noFix() { return vehicle.gps.fix == GpsFix::none; }
bool flatFix() { return vehicle.gps.fix == GpsFix::two_d; }
bool always() { return true; }

struct Row {
    bool (*holds)();
    uint16_t pattern;
};

// Of each light the first row that holds; the last one always does.
// clang-format off
constexpr Row kRed[] ROM = {
    {broken,       kFast},        // all three together
    {armed,        kOn},
    {gyrosUnknown, kFast},        // red and blue in turn: keep it still
    {ready,        kOneFlash},
    {always,       kTwoFlashes},
};
constexpr Row kYellow[] ROM = {
    {broken,       kFast},
    {radioLost,    kTwoFlashes},
    {always,       kOff},
};
constexpr Row kBlue[] ROM = {
    {broken,       kFast},
    {gyrosUnknown, kBetween},
    {noGps,        kOff},
    {noFix,        kFast},
    {flatFix,      kSlow},
    {always,       kOn},
};
// clang-format on

struct Blinking {
    uint8_t tenth;
};
core::FileState<Blinking> blinking{};

bool lit(const Row* row) {
    while (!core::romRead(row->holds)()) ++row;
    return (core::romRead(row->pattern) >> blinking.tenth & 1) != 0;
}

template <class Led>
void show(const Row* rows) {
    if (lit(rows)) {
        Led::on();
    } else {
        Led::off();
    }
}

}  // namespace

void runLights() {
    blinking.tenth = (blinking.tenth + 1) % 16;
    show<board::LedA>(kRed);
    show<board::LedB>(kYellow);
    show<board::LedC>(kBlue);
}

}  // namespace actuators
}  // namespace firmware
