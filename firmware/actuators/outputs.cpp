// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/actuators/outputs.hpp"

#include "control/mixing.hpp"
#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "core/rom.hpp"
#include "firmware/actuators/camera.hpp"
#include "firmware/actuators/flaps.hpp"
#include "firmware/control/attitude_control.hpp"
#include "firmware/sensors/sensors.hpp"
#include "firmware/state/parameters.hpp"
#include "firmware/state/published.hpp"
#include "hal/hang_timer.hpp"
#include "hal/servo_output.hpp"

namespace firmware {

namespace state {
template <>
struct Publisher<ServoState> : Writable<ServoState> {
    using Writable::state;
};
}  // namespace state

namespace actuators {

using namespace state;
using namespace sensors;
using namespace control;
using ::control::Side;
using ::control::surfacePulse_us;
using ::control::throttlePulse_us;

namespace {

constexpr ServoState& published = Publisher<ServoState>::state();

constexpr uint16_t kRefresh_hz = 50;
constexpr uint8_t kFirstFree = 4;                            // outputs 5..8, counted from 0
constexpr uint8_t kAileron = 0, kElevator = 1, kRudder = 3;  // counted from 0
constexpr uint8_t kThrottle = 3;                             // numbered as on the board
constexpr uint16_t kShortest_us = 800, kLongest_us = 2200;

struct Outputs {
    uint8_t held;        // a bit an output: its pulse stays as it is
    uint8_t mode_entry;  // that the outputs were released for
    uint16_t idle_us;    // of the motor while disarmed
    bool was_armed;
};
core::FileState<Outputs> outputs{};

const Channel& range(uint8_t output) { return parameters.channel[output]; }

// RCn_REV turns the control of a pair, with its stick; the kind of the pair turns the servos, so
// that their own RCn_REV is taken out again.
core::Ratio upright(uint8_t output, core::Ratio control) {
    return parameters.channel[output].reverse < 0 ? core::Ratio::fromRaw(-control.raw) : control;
}

uint16_t mixed_us(int8_t kind, Side side, core::Ratio common, core::Ratio differential,
                  uint8_t output) {
    const core::Ratio servo = ::control::mixPair(static_cast<::control::Pair>(kind), side, common,
                                                 differential, core::Ratio(parameters.mixing_gain));
    return surfacePulse_us(range(output), output < kFirstFree ? upright(output, servo) : servo);
}

uint16_t paired_us(int8_t kind, uint8_t output, uint8_t other, core::Ratio differential) {
    const core::Ratio apart = core::Ratio::fromRaw(-upright(other, differential).raw);
    return mixed_us(kind, output == kElevator ? Side::left : Side::right,
                    upright(kElevator, surfaces.elevator), apart, output);
}

uint16_t elevon_us(uint8_t output) {
    return paired_us(parameters.elevon_output, output, kAileron, surfaces.aileron);
}
uint16_t tail_us(uint8_t output) {
    return paired_us(parameters.vtail_output, output, kRudder, surfaces.rudder);
}

uint16_t aileron_us() {
    if (parameters.elevon_output != 0) return elevon_us(kAileron);
    return surfacePulse_us(range(kAileron), surfaces.aileron);
}
uint16_t elevator_us() {
    if (parameters.elevon_output != 0) return elevon_us(kElevator);
    if (parameters.vtail_output != 0) return tail_us(kElevator);
    return surfacePulse_us(range(kElevator), surfaces.elevator);
}
// Low enough for every motor controller. With RC3_REV -1 the long pulse is idle, but a setting that
// is wrong would start the motor: no pulse (0) until arming has confirmed it.
uint16_t idleAtStart_us() {
    constexpr int16_t kMax_us = 1100;
    const Channel& servo = range(kThrottle - 1);
    if (servo.reverse < 0) return 0;
    return static_cast<uint16_t>(servo.min_us < kMax_us ? servo.min_us : kMax_us);
}

// While disarmed the pulse is the one that was idle when it was armed, or at the start: what a
// radio calibration or a parameter set writes meanwhile moves nothing.
uint16_t throttle_us() {
    if (!vehicle.armed) {
        outputs.was_armed = false;
        return outputs.idle_us;
    }
    const Channel& servo = range(kThrottle - 1);
    if (!outputs.was_armed) outputs.idle_us = throttlePulse_us(servo, core::Ratio::fromRaw(0));
    outputs.was_armed = true;
    return throttlePulse_us(servo, surfaces.throttle);
}
uint16_t rudder_us() {
    const bool alone = parameters.vtail_output == 0 || parameters.elevon_output != 0;
    return alone ? surfacePulse_us(range(kRudder), surfaces.rudder) : tail_us(kRudder);
}

using Pulse = uint16_t (*)();
constexpr Pulse kPulses[kFirstFree] ROM = {aileron_us, elevator_us, throttle_us, rudder_us};

// Where both are too much for a surface, the flap gives way: it is the ailerons that keep upright.
uint16_t flaperon_us(uint8_t output, Side side) {
    return mixed_us(static_cast<int8_t>(::control::Pair::up_down), side, surfaces.aileron,
                    flaps.out, output);
}

uint16_t flap_us(uint8_t output) { return throttlePulse_us(range(output), flaps.lever); }
uint16_t autoFlap_us(uint8_t output) { return throttlePulse_us(range(output), flaps.out); }
uint16_t leftFlaperon_us(uint8_t output) { return flaperon_us(output, Side::left); }
uint16_t rightFlaperon_us(uint8_t output) { return flaperon_us(output, Side::right); }
uint16_t shutter_us(uint8_t) { return cameraPulse_us(); }

uint16_t received_us(uint8_t output) {
    const uint16_t received = vehicle.radio.pulse_us[output];
    return received != 0 ? core::limit(received, kShortest_us, kLongest_us)
                         : static_cast<uint16_t>(parameters.channel[output].trim_us);
}

struct Function {
    int8_t number;  // RCn_FUNCTION
    uint16_t (*pulse_us)(uint8_t output);
};
constexpr Function kFunctions[] ROM = {
    {kFlapFunction, flap_us},
    {kAutoFlapFunction, autoFlap_us},
    {kCameraFunction, shutter_us},
    {kLeftFlaperonFunction, leftFlaperon_us},
    {kRightFlaperonFunction, rightFlaperon_us},
};

const Function* functionOf(int8_t number) {
    for (const Function& function : kFunctions)
        if (core::romRead(function.number) == number) return &function;
    return nullptr;
}

uint16_t freePulse_us(uint8_t output) {
    const int8_t number = parameters.output_function[output - kFirstFree];
    if (number != 0)
        if (const Function* function = functionOf(number))
            return core::romRead(function->pulse_us)(output);
    return received_us(output);
}

void put(uint8_t output, uint16_t pulse_us) {
    if (pulse_us == published.servo_us[output]) return;
    published.servo_us[output] = pulse_us;
    hal::servoWrite(output, pulse_us * 2);
}

bool isOutput(uint8_t output) { return output >= 1 && output <= hal::kServos; }
uint8_t bit(uint8_t output) { return static_cast<uint8_t>(1u << (output - 1)); }

}  // namespace

bool isOutputFunction(int8_t number) { return number == 0 || functionOf(number) != nullptr; }

void startOutputs() {
    outputs.held = 0;
    for (uint16_t& pulse_us : published.servo_us) pulse_us = 0;
    surfaces = {};
    outputs.idle_us = idleAtStart_us();
    if (!wrongBoard()) hal::servoStart(kRefresh_hz);
    runOutputs();
}

void runOutputs() {
    hal::hangTimerReset();
    if (wrongBoard()) return;
    if (outputs.mode_entry != vehicle.mode_entries) outputReleaseAll();
    outputs.mode_entry = vehicle.mode_entries;
    uint8_t free = static_cast<uint8_t>(~outputs.held);
    uint8_t i = 0;
    for (; i < kFirstFree; ++i, free >>= 1)
        if (free & 1) put(i, core::romRead(kPulses[i])());
    for (; i < hal::kServos; ++i, free >>= 1)
        if (free & 1) put(i, freePulse_us(i));
}

bool outputOverride(uint8_t output, uint16_t pulse_us) {
    if (!isOutput(output) || output == kThrottle || wrongBoard()) return false;
    outputs.held |= bit(output);
    put(output - 1, pulse_us == 0 ? 0 : core::limit(pulse_us, kShortest_us, kLongest_us));
    return true;
}

void outputRelease(uint8_t output) {
    if (isOutput(output)) outputs.held &= static_cast<uint8_t>(~bit(output));
}

void outputReleaseAll() { outputs.held = 0; }

void holdSurfacesAtEnds() {
    surfaces.aileron = surfaces.elevator = surfaces.rudder = core::Ratio(1.0f);
    for (uint8_t i = 0; i < kFirstFree; ++i)  // the motor's is not taken over
        (void)outputOverride(i + 1, core::romRead(kPulses[i])());
}

void outputPassStick(uint8_t output, uint16_t pulse_us) {
    published.servo_us[output] = pulse_us;
    hal::servoWrite(output, pulse_us * 2);
}

uint16_t outputPulse_us(uint8_t output) {
    return isOutput(output) ? published.servo_us[output - 1] : 0;
}

}  // namespace actuators
}  // namespace firmware
