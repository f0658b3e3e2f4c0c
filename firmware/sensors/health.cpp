// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/sensors/health.hpp"

#include "core/based.hpp"
#include "core/file_state.hpp"
#include "core/maths.hpp"
#include "core/rom.hpp"
#include "firmware/state/vehicle.hpp"

namespace firmware {
namespace sensors {

using namespace state;

namespace {

// A quiet sensor in calm air may repeat its reading for seconds. What shows that it is stuck.
enum class Evidence : uint8_t { time, climb, turn };

struct Limits {
    uint16_t jump;   // from one reading to the next, in the reading's unit
    uint8_t silent;  // 0.1 s without a reading
    uint8_t still;   // 0.1 s without a change, while there is evidence that it must change
    Evidence evidence;
    uint8_t impossible;  // an impossible reading costs
    uint8_t trust;       // and a possible one earns
};

// An airspeed that stays while GPS and wind say otherwise is reported by the estimator.
// clang-format off
constexpr Limits kLimits[kSensors] ROM = {
    // jump  silent still                impossible trust
    {4 * 1024,  2,     2, Evidence::time,  20,    1},  // inertial: rates of all axes, 4 rad/s, 100 Hz
    { 120,     10,    10, Evidence::climb, 12,    1},  // barometer: 120 Pa, 80 Hz
    { 160,     20,   250, Evidence::time,  12,    1},  // airspeed: 0.1 V in 1/8 counts, 50 Hz
    { 150,     20,    20, Evidence::turn,  20,    2},  // compass: mG of all axes, 50 Hz
    {2000,     30,    30, Evidence::time,  40,   12},  // GPS: 20 m/s, 5 Hz, some 1 Hz
};
// clang-format on

constexpr uint8_t kMax = 0xFF;
constexpr uint8_t kFaulty = 200;
constexpr uint8_t kContradicted = 4;  // readings' worth

struct Health {
    int16_t seen;
    bool heard;         // since the checks began: in the air they begin with a restart
    uint8_t silent;     // 0.1 s
    uint8_t still;      // 0.1 s
    uint8_t suspicion;  // above kFaulty it is faulty, until there is none
};

struct Watch {
    Health sensors[kSensors];
    uint8_t ailing;  // a bit a sensor
};
core::FileState<Watch> watch{};

uint8_t bit(Sensor sensor) { return static_cast<uint8_t>(1 << static_cast<uint8_t>(sensor)); }
Health& of(Sensor sensor) { return core::based(watch.sensors[static_cast<uint8_t>(sensor)]); }
const Limits& limitsOf(Sensor sensor) { return kLimits[static_cast<uint8_t>(sensor)]; }

void add(Health& health, uint16_t suspicion) {
    suspicion += health.suspicion;
    health.suspicion = suspicion > kMax ? kMax : static_cast<uint8_t>(suspicion);
}

bool fixesUsable() { return vehicle.gps.fix == GpsFix::three_d && !isFaulty(Sensor::gps); }

// Without fixes nobody sees it climb, without gyros nobody sees it turn: then time must do.
bool mustChange(Evidence evidence) {
    if (evidence == Evidence::climb)
        return !fixesUsable() || fabsf(vehicle.gps.velocity_mps.z) > 0.5f;
    return evidence == Evidence::time || isFaulty(Sensor::inertial) || turns();
}

// True: at its limit, where it stays.
bool countsUp(uint8_t& count, uint8_t limit) {
    if (count < limit) ++count;
    return count >= limit;
}

void update(uint8_t index) {
    Health& health = watch.sensors[index];
    if (!health.heard) return;  // its driver says whether it works
    const uint8_t bit = static_cast<uint8_t>(1 << index);
    const uint8_t still = core::romRead(kLimits[index].still);
    const bool silent = countsUp(health.silent, core::romRead(kLimits[index].silent));
    const bool stuck = mustChange(core::romRead(kLimits[index].evidence))
                           ? countsUp(health.still, still)
                           : health.still >= still;
    if (silent || stuck) health.suspicion = kMax;
    if (health.suspicion >= kFaulty) watch.ailing |= bit;
    if (health.suspicion == 0) watch.ailing &= static_cast<uint8_t>(~bit);
}

}  // namespace

bool turns() {
    constexpr int16_t kLeast = core::BodyRate(0.1f).raw;
    const auto fast = [](core::BodyRate axis) { return axis.raw > kLeast || axis.raw < -kLeast; };
    const auto& rate = vehicle.imu.rate_rads;
    return fast(rate.x) || fast(rate.y) || fast(rate.z);
}

void startHealth() {
    watch.ailing = 0;
    for (Health& health : watch.sensors) {
        health.heard = false;
        health.silent = health.still = health.suspicion = 0;
    }
}

bool acceptReading(Sensor sensor, int16_t reading, bool possible) {
    Health& health = of(sensor);
    const Limits& limits = limitsOf(sensor);
    const int16_t change =
        static_cast<int16_t>(static_cast<uint16_t>(reading) - static_cast<uint16_t>(health.seen));
    const uint16_t jump = static_cast<uint16_t>(change < 0 ? -change : change);
    health.seen = reading;
    health.silent = 0;
    health.heard = true;
    if (!possible || jump > core::romRead(limits.jump)) {
        add(health, core::romRead(limits.impossible));
        return !vehicle.estimate.flying;
    }
    if (change == 0) return true;
    health.still = 0;
    // Only fixes can contradict an airspeed that is wrong by a steady amount.
    if (sensor == Sensor::airspeed && isFaulty(sensor) && !fixesUsable()) return true;
    const uint8_t trust = core::romRead(limits.trust);
    health.suspicion = health.suspicion > trust ? health.suspicion - trust : 0;
    return true;
}

void reportChange(Sensor sensor) { of(sensor).still = 0; }

void reportInconsistency(Sensor sensor) {
    add(of(sensor), core::romRead(limitsOf(sensor).impossible) * kContradicted);
}

bool isFaulty(Sensor sensor) { return (watch.ailing & bit(sensor)) != 0; }

void watchHealth() {
    if (!vehicle.estimate.flying) return startHealth();
    for (uint8_t i = 0; i < kSensors; ++i) update(i);
}

}  // namespace sensors
}  // namespace firmware
