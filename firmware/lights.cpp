// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/lights.hpp"

#include "board.hpp"
#include "firmware/arming.hpp"
#include "firmware/vehicle.hpp"

namespace firmware {
namespace {

// One bit a tenth of a second, sixteen of them, over and over.
constexpr uint16_t kOff = 0x0000;
constexpr uint16_t kOn = 0xFFFF;
constexpr uint16_t kOneFlash = 0x0003;
constexpr uint16_t kTwoFlashes = 0x0033;
constexpr uint16_t kFast = 0x5555;
constexpr uint16_t kSlow = 0x3333;

uint8_t tenth;

template <class Led>
void show(uint16_t pattern) {
    if ((pattern >> tenth) & 1) {
        Led::on();
    } else {
        Led::off();
    }
}

uint16_t armedPattern() {
    if (vehicle.armed) return kOn;
    if (!vehicle.imu.calibrated) return kFast;
    return prearmOk() ? kOneFlash : kTwoFlashes;
}

uint16_t gpsPattern() {
    switch (vehicle.gps.fix) {
        case GpsFix::three_d:
            return kOn;
        case GpsFix::two_d:
            return kSlow;
        case GpsFix::none:
            return kFast;
        case GpsFix::no_gps:
            break;
    }
    return kOff;
}

}  // namespace

void runLights() {
    tenth = (tenth + 1) % 16;
    show<board::LedA>(armedPattern());
    show<board::LedB>(vehicle.radio.lost ? kTwoFlashes : kOff);
    show<board::LedC>(gpsPattern());
}

}  // namespace firmware
