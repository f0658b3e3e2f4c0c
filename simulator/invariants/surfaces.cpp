// SPDX-License-Identifier: GPL-3.0-or-later
// No surface stays at its stop, where it controls nothing, and none swings from side to side: in
// the air, armed, in a mode that holds an attitude, with the sticks away from their ends. Not
// while, or ten seconds after, the inertial sensor or the airspeed sensor fails: then the surfaces
// follow something else, or their effect is not known. Not while too slow to fly, not in the two
// seconds after a restart.
#include <algorithm>
#include <cmath>
#include <deque>

#include "simulator/invariants/invariant.hpp"
#include "simulator/invariants/modes_of_flight.hpp"

namespace simulator::invariants {
namespace {

constexpr double kLongest_s = 2, kNear_us = 3, kSlow_mps = 9, kAfterFault_s = 10;

constexpr size_t kAileron = 0, kElevator = 1, kRudder = 3;

bool excused(const Snapshot& now, const History& history) {
    const double now_s = now.time_s();
    const uint32_t mode = history.heard().mode, before = history.heardBefore().mode;
    const auto failed = [&](Faulty sensor) {
        return now_s - history.faulted_s(sensor) < kAfterFault_s;
    };
    return now.truth.on_ground || now.truth.crashed || !history.heard().armed ||
           pilotHasTheSurfaces(mode) || pilotHasTheSurfaces(before) ||
           now.truth.airspeed_mps < kSlow_mps || failed(Faulty::imu) || failed(Faulty::airspeed) ||
           history.within(Cause::stick, now_s - kLongest_s, now_s) ||
           history.within(Cause::overrides, now_s - kLongest_s, now_s) ||
           history.within(Cause::restart, now_s - kLongest_s, now_s) ||
           history.last_s(Cause::servo) > kNever_s;
}

struct Travel {
    double min_us, max_us;
};
Travel travelOf(size_t surface, const History& history) {
    const std::string channel = "RC" + std::to_string(surface + 1);
    return {history.parameter(channel + "_MIN", 1100), history.parameter(channel + "_MAX", 1900)};
}

class SurfacesOffTheirStops : public Invariant {
    void frame(const Snapshot& now, const History& history, const Report& report) override {
        const double now_s = now.time_s();
        const bool lawful = excused(now, history);
        for (const size_t surface : {kAileron, kElevator, kRudder}) {
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
        const Travel travel = travelOf(surface, history);
        return pulse_us > 0 &&
               (pulse_us < travel.min_us + kNear_us || pulse_us > travel.max_us - kNear_us);
    }

    std::array<double, 8> free_s_{};
};

// From beyond half of its travel on one side to beyond half on the other, and again: a loop that is
// not stable. Not in AUTOTUNE, which shakes the airplane to measure it, and not with a faulty
// receiver, whose sticks are mixed in.
class SurfacesDoNotSwing : public Invariant {
    void frame(const Snapshot& now, const History& history, const Report& report) override {
        const bool lawful = excused(now, history) || history.heard().mode == kAutotune ||
                            history.heardBefore().mode == kAutotune ||
                            now.time_s() - history.faulted_s(Faulty::radio) < kAfterFault_s;
        for (const size_t surface : {kAileron, kElevator, kRudder}) {
            Swing& swing = swings_[surface];
            if (lawful) swing = Swing();
            const int side = sideOf(surface, now.servo_us[surface], history);
            if (side != 0 && side != swing.side && swing.changes(now.time_s(), side) > kMaxChanges)
                report(now.time_s(),
                       text("output %zu has changed its side %zu times in %.1f s in mode %u, "
                            "%.1f m/s, bank %.0f",
                            surface + 1, swing.changed_s.size(),
                            now.time_s() - swing.changed_s.front(), history.heard().mode,
                            now.truth.airspeed_mps, now.truth.roll_rad / kDegree));
        }
    }

    static int sideOf(size_t surface, double pulse_us, const History& history) {
        const Travel travel = travelOf(surface, history);
        const double half_us = (travel.max_us - travel.min_us) / 4;
        if (pulse_us <= 0) return 0;
        return pulse_us < travel.min_us + half_us ? -1 : pulse_us > travel.max_us - half_us ? 1 : 0;
    }

    static constexpr double kWithin_s = 10;
    static constexpr size_t kMaxChanges = 8;

    struct Swing {
        int side = 0;
        std::deque<double> changed_s;  // of the last kWithin_s

        size_t changes(double now_s, int to_side) {
            side = to_side;
            changed_s.push_back(now_s);
            while (now_s - changed_s.front() > kWithin_s) changed_s.pop_front();
            return changed_s.size();
        }
    };
    std::array<Swing, 8> swings_{};
};

}  // namespace

std::unique_ptr<Invariant> surfacesOffTheirStops() {
    return std::make_unique<SurfacesOffTheirStops>();
}
std::unique_ptr<Invariant> surfacesDoNotSwing() { return std::make_unique<SurfacesDoNotSwing>(); }

}  // namespace simulator::invariants
