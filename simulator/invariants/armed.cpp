// SPDX-License-Identifier: GPL-3.0-or-later
// Armed in the air, and armed again after a restart there.
#include <algorithm>
#include <cmath>

#include "simulator/invariants/invariant.hpp"
#include "simulator/invariants/modes_of_flight.hpp"

namespace simulator::invariants {
namespace {

constexpr double kHigh_m = 5;

bool inTheAir(const Truth& truth) { return !truth.on_ground && truth.height_m > kHigh_m; }

// The inertial sensor, alone or with the barometer on its bus.
bool sensorsFail(const Snapshot& now) {
    return now.faulty[static_cast<size_t>(Faulty::imu)] ||
           now.faulty[static_cast<size_t>(Faulty::spi)];
}

// By one of these it is seen in the air after a restart.
bool evidenceFails(const Snapshot& now) {
    return now.faulty[static_cast<size_t>(Faulty::barometer)] ||
           now.faulty[static_cast<size_t>(Faulty::airspeed)];
}

// From an armed heartbeat to a disarmed one, high above the ground all the time.
class ArmedInTheAir : public Invariant {
    void frame(const Snapshot& now, const History& history, const Report& report) override {
        if (!inTheAir(now.truth)) low_s_ = now.time_s();
        if (history.heartbeats() == heartbeats_) return;
        heartbeats_ = history.heartbeats();
        const Heard &before = history.heardBefore(), &after = history.heard();
        if (!before.armed || after.armed) return;
        const double from_s = before.time_s - 1.5;
        const bool caused = history.within(Cause::forces, from_s, after.time_s) ||
                            history.within(Cause::restart, from_s, now.time_s());
        if (caused || low_s_ > before.time_s - 1) return;
        report(after.time_s, text("disarmed %.0f m above the ground", now.truth.height_m));
    }

    uint64_t heartbeats_ = 0;
    double low_s_ = kNever_s;
};

// From a disarmed heartbeat to an armed one, and nobody armed it. One that was armed may say for a
// moment that it is not, while it finds its flight again after a restart.
class ArmedByACommand : public Invariant {
    void frame(const Snapshot& now, const History& history, const Report& report) override {
        constexpr double kFindsItself_s = 4;
        const double now_s = now.time_s();
        if (history.heard().armed) armed_s_ = history.heard().time_s;
        if (now.restarts != restarts_ && now_s - armed_s_ < kFindsItself_s)
            resumes_s_ = restarted_s_ = now_s;
        restarts_ = now.restarts;
        if (now_s - resumes_s_ < kFindsItself_s && (sensorsFail(now) || evidenceFails(now)))
            resumes_s_ = now_s;
        if (movesAsOneFlies(now)) moved_s_ = now_s;
        if (history.heartbeats() == heartbeats_) return;
        heartbeats_ = history.heartbeats();
        const Heard &before = history.heardBefore(), &after = history.heard();
        if (before.armed || !after.armed || before.time_s <= kNever_s) return;
        if (now_s - resumes_s_ < kFindsItself_s || receiverSaysSo(now)) return;
        const double from_s = before.time_s - 1.5;
        for (const Cause cause : {Cause::arms, Cause::rudder, Cause::overrides})
            if (history.within(cause, from_s, after.time_s)) return;
        report(after.time_s, text("armed, in mode %u", after.mode));
    }

    static bool movesAsOneFlies(const Snapshot& now) {
        constexpr double kMoves_mps = 6;
        return std::hypot(now.truth.velocity_north_mps, now.truth.velocity_east_mps) > kMoves_mps;
    }
    // It starts within half a minute, and sees what moves as fast as one flies: half a second
    // later, and a heartbeat says so within another second.
    bool receiverSaysSo(const Snapshot& now) const {
        constexpr double kStarts_s = 32, kHeard_s = 1.5;
        return now.time_s() - restarted_s_ < kStarts_s && now.time_s() - moved_s_ < kHeard_s;
    }

    unsigned restarts_ = 0;
    double armed_s_ = kNever_s, resumes_s_ = kNever_s, restarted_s_ = kNever_s;
    double moved_s_ = kNever_s;
    uint64_t heartbeats_ = 0;
};

// The surfaces are still for as long as the processor starts, then in the airplane's own motion.
class FliesOnAfterARestart : public Invariant {
    void frame(const Snapshot& now, const History& history, const Report& report) override {
        const double now_s = now.time_s();
        if (now.restarts != restarts_) restarted(now_s, history);
        restarts_ = now.restarts;
        if (!inTheAir(now.truth) || now.truth.crashed || !history.heard().armed) low_s_ = now_s;
        faulty_ = sensorsFail(now);
        before_s_ = now_s;
        if (waiting_s_ > 0 && faulty_) faulted_s_ = now_s;
        if (waiting_s_ > 0 && !mayBeSeen(now)) unseen_s_ = now_s;
        if (waiting_s_ > 0) look(now, history, report);
        pulses_ = now.servo_us;
    }
    // After the button it starts disarmed, and what comes next finds it so.
    void provoked(const Provoked& what) override {
        survivable_ = what.survivable;
        if (!survivable_) waiting_s_ = 0, low_s_ = before_s_;
    }

    // By the barometer, where no other sensor says so: out of reach of a hand, and a little more.
    static bool mayBeSeen(const Snapshot& now) {
        constexpr double kOutOfReach_m = 12;
        return !now.faulty[static_cast<size_t>(Faulty::barometer)] &&
               std::abs(now.truth.height_m) > kOutOfReach_m;
    }
    // Long enough in the air that the record of the flight says so.
    bool fliesOn() const {
        constexpr double kFlies_s = 5;
        return survivable_ && !faulty_ && before_s_ - low_s_ > kFlies_s;
    }
    // Another one before the first has been looked at counts from its own beginning, in the mode
    // from before both.
    void restarted(double now_s, const History& history) {
        if (waiting_s_ <= 0 && !fliesOn()) return;
        if (waiting_s_ <= 0) mode_before_ = history.heard().mode;
        waiting_s_ = now_s;
        moved_after_s_ = -1;
        seen_early_ = false;
    }
    // In its first two seconds the barometer decides, later the receiver alone; one whose fixes do
    // not fit counts for nothing (docs/restart.md). The board has to say so.
    bool mayGiveUp(const History& history, double begun_s, double now_s) const {
        return !seen_early_ && history.saidWithin("Not armed again", begun_s, now_s);
    }

    void look(const Snapshot& now, const History& history, const Report& report) {
        constexpr double kMovesWithin_s = 0.5, kHeartbeats_s = 3, kBarometers_s = 2;
        const double now_s = now.time_s(), begun_s = static_cast<double>(now.begun_us) * 1e-6;
        if (now.truth.crashed || now.truth.on_ground) return void(waiting_s_ = 0);
        if (begun_s < waiting_s_ - 0.02) return;  // the bootloader has the processor
        if (now_s < begun_s + kBarometers_s) seen_early_ = seen_early_ || mayBeSeen(now);
        for (const size_t surface : {0, 1, 3})
            if (moved_after_s_ < 0 && pulses_[surface] > 0 && now.servo_us[surface] > 0 &&
                std::abs(pulses_[surface] - now.servo_us[surface]) > 1)
                moved_after_s_ = now_s - begun_s;
        if (now_s < std::max({begun_s, faulted_s_, unseen_s_}) + kHeartbeats_s) return;
        // what was between two heartbeats is not heard of, what may have caused it is
        const double set_from_s = waiting_s_ - 1.5;
        waiting_s_ = 0;
        const bool heard = history.heard().time_s > begun_s + 1;
        if (heard && !history.heard().armed && !history.within(Cause::forces, set_from_s, now_s) &&
            !mayGiveUp(history, begun_s, now_s))
            report(now_s,
                   text("disarmed after a restart %.0f m above the ground", now.truth.height_m));
        const bool other_mode = history.within(Cause::mode_switch, set_from_s, begun_s + 1.5) ||
                                history.within(Cause::flight_mode, set_from_s, begun_s + 1.5);
        const bool still = moved_after_s_ < 0 || moved_after_s_ > kMovesWithin_s;
        if (still && faulted_s_ < begun_s && !other_mode && !pilotHasTheSurfaces(mode_before_) &&
            !pilotHasTheSurfaces(history.heard().mode))
            report(now_s, text("no surface moved within 0.5 s of a restart; after %.2f s",
                               moved_after_s_));
    }

    unsigned restarts_ = 0;
    bool survivable_ = false, faulty_ = false, seen_early_ = false;
    double low_s_ = 0, before_s_ = 0, waiting_s_ = 0, moved_after_s_ = -1;
    double faulted_s_ = kNever_s;  // the inertial sensor, last
    double unseen_s_ = kNever_s;   // when no barometer could see it in the air, last
    uint32_t mode_before_ = 0;     // in which it goes on; a failsafe may set another meanwhile
    std::array<double, 8> pulses_{};
};

}  // namespace

std::unique_ptr<Invariant> armedByACommand() { return std::make_unique<ArmedByACommand>(); }
std::unique_ptr<Invariant> armedInTheAir() { return std::make_unique<ArmedInTheAir>(); }
std::unique_ptr<Invariant> fliesOnAfterARestart() {
    return std::make_unique<FliesOnAfterARestart>();
}

}  // namespace simulator::invariants
