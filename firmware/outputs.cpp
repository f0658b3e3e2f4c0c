// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/outputs.hpp"

#include "control/mixing.hpp"
#include "core/maths.hpp"
#include "core/rom.hpp"
#include "firmware/attitude_control.hpp"
#include "firmware/parameters.hpp"
#include "firmware/vehicle.hpp"
#include "hal/servo_output.hpp"

namespace firmware {
namespace {

constexpr uint16_t kRefresh_hz = 50;
constexpr uint8_t kFirstFree = 4;  // outputs 5..8, counted from 0
constexpr uint8_t kFree = hal::kServos - kFirstFree;
constexpr uint16_t kShortest_us = 800, kLongest_us = 2200;
constexpr uint16_t kFollowsReceiver = 0xFFFF;

uint16_t held_us[kFree];  // kFollowsReceiver: nobody holds it; 0: silent

control::ServoRange range(uint8_t output) {
    const Channel& channel = parameters.channel[output];
    return {channel.min_us, channel.trim_us, channel.max_us, channel.reverse};
}

uint16_t aileron_us() { return surfacePulse_us(range(0), surfaces.aileron); }
uint16_t elevator_us() { return surfacePulse_us(range(1), surfaces.elevator); }
uint16_t throttle_us() { return throttlePulse_us(range(2), vehicle.armed ? surfaces.throttle : 0); }
uint16_t rudder_us() { return surfacePulse_us(range(3), surfaces.rudder); }

using Pulse = uint16_t (*)();
constexpr Pulse kPulses[kFirstFree] ROM = {aileron_us, elevator_us, throttle_us, rudder_us};

uint16_t freePulse_us(uint8_t output) {
    const uint16_t held = held_us[output - kFirstFree];
    if (held != kFollowsReceiver) return held;
    const uint16_t received = vehicle.radio.pulse_us[output];
    return received != 0 ? core::limit(received, kShortest_us, kLongest_us)
                         : static_cast<uint16_t>(parameters.channel[output].trim_us);
}

void put(uint8_t output, uint16_t pulse_us) {
    if (pulse_us == vehicle.servo_us[output]) return;
    vehicle.servo_us[output] = pulse_us;
    hal::servoWrite(output, pulse_us * 2);
}

bool isFree(uint8_t output) { return output > kFirstFree && output <= hal::kServos; }

}  // namespace

void startOutputs() {
    for (uint16_t& held : held_us) held = kFollowsReceiver;
    for (uint16_t& pulse_us : vehicle.servo_us) pulse_us = 0;
    surfaces = {};
    hal::servoStart(kRefresh_hz);
    runOutputs();
}

void runOutputs() {
    if (vehicle.mode_changed) outputReleaseAll();
    for (uint8_t i = 0; i < kFirstFree; ++i) put(i, core::romRead(kPulses[i])());
    for (uint8_t i = kFirstFree; i < hal::kServos; ++i) put(i, freePulse_us(i));
}

bool outputOverride(uint8_t output, uint16_t pulse_us) {
    if (!isFree(output)) return false;
    held_us[output - 1 - kFirstFree] =
        pulse_us == 0 ? 0 : core::limit(pulse_us, kShortest_us, kLongest_us);
    return true;
}

void outputRelease(uint8_t output) {
    if (isFree(output)) held_us[output - 1 - kFirstFree] = kFollowsReceiver;
}

void outputReleaseAll() {
    for (uint16_t& held : held_us) held = kFollowsReceiver;
}

uint16_t outputPulse_us(uint8_t output) {
    return output >= 1 && output <= hal::kServos ? vehicle.servo_us[output - 1] : 0;
}

}  // namespace firmware
