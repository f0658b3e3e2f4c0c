// SPDX-License-Identifier: GPL-3.0-or-later
// The motor at its pin: off while disarmed, and off while the airplane stands and nobody wants it
// to run.
#include <algorithm>
#include <cmath>

#include "simulator/invariants/invariant.hpp"
#include "simulator/invariants/modes_of_flight.hpp"

namespace simulator::invariants {
namespace {

constexpr size_t kMotor = 2;
constexpr double kMaxIdle_us = 1100;  // what every motor controller takes for off
constexpr double kTick_us = 2;

// The pulse that is off: what the board sends first, at most 1100 us; once it was armed, the
// closed end of the throttle as it was set then.
class Idle {
public:
    double most_us(const Snapshot& now, const History& history) {
        const double now_s = now.time_s(), pulse_us = now.servo_us[kMotor];
        if (now.restarts != restarts_) boot_us_ = 0;
        restarts_ = now.restarts;
        if (boot_us_ <= 0) boot_us_ = std::min(pulse_us, kMaxIdle_us);
        constexpr double kText_s = 0.5;
        if (history.heard().armed || history.saidWithin("Throttle armed", now_s - kText_s, now_s))
            armed_us_ = closedEnd_us(history);
        return std::max({boot_us_, armed_us_, 0.0});
    }

private:
    static double closedEnd_us(const History& history) {
        return history.parameter("RC3_REV", 1) < 0 ? history.parameter("RC3_MAX", 1900)
                                                   : history.parameter("RC3_MIN", 1100);
    }
    unsigned restarts_ = 0;
    double boot_us_ = 0, armed_us_ = 0;
};

// Arming is heard once a second: a pulse counts between two heartbeats that both say disarmed, when
// nothing was done meanwhile that arms.
class MotorIdleWhenDisarmed : public Invariant {
    void frame(const Snapshot& now, const History& history, const Report& report) override {
        const double most_us = idle_.most_us(now, history), pulse_us = now.servo_us[kMotor];
        if (pulse_us > most_us + kTick_us && seen_us_ <= 0) {
            seen_us_ = pulse_us;
            seen_s_ = now.time_s();
            most_us_ = most_us;
        }
        if (history.heartbeats() == heartbeats_) return;
        heartbeats_ = history.heartbeats();
        constexpr double kUnderWay_s = 0.3;  // of the heartbeat, in the buffers of the link
        if (seen_us_ <= 0 || history.heard().time_s < seen_s_ + kUnderWay_s) return;
        if (disarmedAllTheTime(history))
            report(seen_s_, text("the motor's pulse is %.0f us, idle %.0f us, disarmed", seen_us_,
                                 most_us_));
        seen_us_ = 0;
    }

    bool disarmedAllTheTime(const History& history) const {
        const Heard &before = history.heardBefore(), &after = history.heard();
        if (before.armed || after.armed || before.time_s > seen_s_) return false;
        const double from_s = std::max(before.time_s, 0.0) - 1.5;
        for (const Cause cause : {Cause::arms, Cause::rudder, Cause::restart, Cause::overrides})
            if (history.within(cause, from_s, after.time_s)) return false;
        return !history.saidWithin("Throttle", from_s, after.time_s);
    }

    Idle idle_;
    uint64_t heartbeats_ = 0;
    double seen_us_ = 0, seen_s_ = 0, most_us_ = 0;
};

class MotorIdleOnTheGround : public Invariant {
    void frame(const Snapshot& now, const History& history, const Report& report) override {
        constexpr double kStill_mps = 0.5, kStands_s = 5, kPatience_s = 2.5;
        constexpr double kTurns_us = 20;
        const Truth& truth = now.truth;
        const double now_s = now.time_s(), most_us = idle_.most_us(now, history);
        const double speed_mps = std::hypot(truth.velocity_north_mps, truth.velocity_east_mps);
        const bool still = truth.on_ground && !truth.crashed && speed_mps < kStill_mps;
        if (!still) moved_s_ = now_s;
        const bool turns = history.heard().armed && now.servo_us[kMotor] > most_us + kTurns_us;
        if (!turns || asked(now_s, history) || unseen(now) || climbs(now_s, history))
            lawful_s_ = now_s;
        if (now_s - moved_s_ < kStands_s || now_s - lawful_s_ < kPatience_s) return;
        report(now_s, text("it stands in mode %u, the motor's pulse is %.0f us, idle %.0f us",
                           history.heard().mode, now.servo_us[kMotor], most_us));
    }

    // By receiver or barometer it is seen to stand: for seconds after both have failed each of
    // their readings is still doubted, and after that it takes 4 s.
    bool unseen(const Snapshot& now) {
        constexpr double kTrusted_s = 7, kSeen_s = 4;
        if (now.faulty[static_cast<size_t>(Faulty::gps)] &&
            now.faulty[static_cast<size_t>(Faulty::barometer)])
            unseen_s_ = now.time_s();
        return now.time_s() - unseen_s_ < kTrusted_s + kSeen_s;
    }

    // Where a wrong scale of the accelerometer was set, it seems to climb after a restart until the
    // barometer has shown the error.
    static bool climbs(double now_s, const History& history) {
        constexpr double kShown_s = 8, kWrong = 0.05;
        return std::abs(history.parameter("INS_ACCSCAL_Z", 1) - 1) > kWrong &&
               history.within(Cause::restart, now_s - kShown_s, now_s);
    }

    static bool asked(double now_s, const History& history) {
        constexpr double kMoment_s = 3;
        const uint32_t mode = history.heard().mode;
        if (takesOffWhenOrdered(mode) || takesOffWhenOrdered(history.heardBefore().mode))
            return true;
        const bool opened = history.within(Cause::throttle, now_s - kMoment_s, now_s) ||
                            history.within(Cause::overrides, now_s - kMoment_s, now_s) ||
                            stickMeansAnother(history);
        return opened &&
               (pilotHasTheThrottle(mode) || pilotHasTheThrottle(history.heardBefore().mode) ||
                history.parameter("THR_SUPP_MAN", 0) > 0);
    }
    // Where the throttle's channel was set otherwise, a closed stick may be an open one.
    static bool stickMeansAnother(const History& history) {
        return history.parameter("RC3_REV", 1) < 0 || history.parameter("RC3_MIN", 1100) < 1090 ||
               history.parameter("RCMAP_THROTTLE", 3) != 3;
    }

    Idle idle_;
    double moved_s_ = 0, lawful_s_ = 0, unseen_s_ = kNever_s;
};

}  // namespace

std::unique_ptr<Invariant> motorIdleWhenDisarmed() {
    return std::make_unique<MotorIdleWhenDisarmed>();
}
std::unique_ptr<Invariant> motorIdleOnTheGround() {
    return std::make_unique<MotorIdleOnTheGround>();
}

}  // namespace simulator::invariants
