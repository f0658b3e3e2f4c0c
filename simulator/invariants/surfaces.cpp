// SPDX-License-Identifier: GPL-3.0-or-later
// A surface that stays at its stop moves the airplane no more: in the air, armed, in a mode that
// holds an attitude, with the sticks away from their ends. Not while, or ten seconds after, the
// inertial sensor or the airspeed sensor fails: then the surfaces follow something else, or their
// effect is not known. Not while too slow to fly, not in the half second after a restart.
#include <algorithm>
#include <cmath>

#include "simulator/invariants/invariant.hpp"
#include "simulator/invariants/modes_of_flight.hpp"

namespace simulator::invariants {
namespace {

constexpr double kLongest_s = 2, kNear_us = 3, kSlow_mps = 9, kAfterFault_s = 10;

class SurfacesOffTheirStops : public Invariant {
    void frame(const Snapshot& now, const History& history, const Report& report) override {
        const double now_s = now.time_s();
        const bool lawful = excused(now, history);
        for (const size_t surface : {0, 1, 3}) {
            if (lawful || !atStop(surface, now.servo_us[surface], history)) {
                free_s_[surface] = now_s;
            } else if (now_s - free_s_[surface] > kLongest_s) {
                report(now_s,
                       text("output %zu has been at %.0f us for %.1f s in mode %u, %.1f m/s, "
                            "bank %.0f, pitch %.0f",
                            surface + 1, now.servo_us[surface], now_s - free_s_[surface],
                            history.heard().mode, now.truth.airspeed_mps,
                            now.truth.roll_rad / kDegree, now.truth.pitch_rad / kDegree));
            }
        }
    }

    static bool atStop(size_t surface, double pulse_us, const History& history) {
        const std::string channel = "RC" + std::to_string(surface + 1);
        const double min_us = history.parameter(channel + "_MIN", 1100);
        const double max_us = history.parameter(channel + "_MAX", 1900);
        return pulse_us > 0 && (pulse_us < min_us + kNear_us || pulse_us > max_us - kNear_us);
    }

    static bool excused(const Snapshot& now, const History& history) {
        const double now_s = now.time_s();
        const uint32_t mode = history.heard().mode, before = history.heardBefore().mode;
        const auto failed = [&](Faulty sensor) {
            return now_s - history.faulted_s(sensor) < kAfterFault_s;
        };
        return now.truth.on_ground || now.truth.crashed || !history.heard().armed ||
               pilotHasTheSurfaces(mode) || pilotHasTheSurfaces(before) ||
               now.truth.airspeed_mps < kSlow_mps || failed(Faulty::imu) ||
               failed(Faulty::airspeed) ||
               history.within(Cause::stick, now_s - kLongest_s, now_s) ||
               history.within(Cause::overrides, now_s - kLongest_s, now_s) ||
               history.within(Cause::restart, now_s - kLongest_s, now_s) ||
               history.last_s(Cause::servo) > kNever_s;
    }

    std::array<double, 8> free_s_{};
};

}  // namespace

std::unique_ptr<Invariant> surfacesOffTheirStops() {
    return std::make_unique<SurfacesOffTheirStops>();
}

}  // namespace simulator::invariants
