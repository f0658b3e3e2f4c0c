// SPDX-License-Identifier: GPL-3.0-or-later
// What is reported of an airplane that stands: where it is, and that it does not move. The bounds
// are the sensors' errors (simulator/devices/errors.hpp) with room for what the filters make of
// them: the position wanders by 0.6 m one sigma and the height by 1.5 m, the GPS's speed is off by
// 0.05 m/s, the airspeed's zero by 0.02 V, which is learnt.
#include <algorithm>
#include <cmath>

#include "simulator/invariants/invariant.hpp"

namespace simulator::invariants {
namespace {

constexpr double kAway_m = 20 + 4 * 0.6, kHeight_m = 15, kSpeed_mps = 3, kAirspeed_mps = 5;
constexpr double kStart_s = 15;             // until gyros are zeroed and the position is found
constexpr double kZeroed_s = 5;             // by then heights are
constexpr double kStands_s = 10;            // after it has moved
constexpr double kAfterFault_s = 60;        // a position that had drifted is put right slowly
constexpr double kMetresPerE7 = 0.0111319;  // of latitude, of 1e-7 degrees

class StandsStill : public Invariant {
    void frame(const Snapshot& now, const History& history, const Report& report) override {
        const double now_s = now.time_s();
        const Truth& truth = now.truth;
        const double speed_mps = std::hypot(truth.velocity_north_mps, truth.velocity_east_mps);
        const double begun_s = static_cast<double>(now.begun_us) * 1e-6;
        const bool disturbed = now_s - history.last_s(Cause::fault) < kAfterFault_s;
        const bool moves = !truth.on_ground || truth.crashed || speed_mps > 0.2;
        if (moves || disturbed || now_s - begun_s < kStart_s) unsettled_s_ = now_s;
        zeroWrongly(now, now_s - begun_s < kZeroed_s, history.heard().armed);
        if (now_s - unsettled_s_ < kStands_s) return;
        if (history.position_s() > unsettled_s_)
            position(truth, *history.position(), now_s, report);
        if (history.hud_s() > unsettled_s_) airspeed(truth, *history.hud(), now_s, report);
    }

    // Heights are zeroed at the start and at arming, which is refused while the receiver says
    // otherwise: until then those of a barometer that failed at the start are wrong.
    void zeroWrongly(const Snapshot& now, bool zeroes, bool armed) {
        if (zeroes && now.faulty[static_cast<size_t>(Faulty::barometer)]) zeroed_wrong_ = true;
        if (armed) zeroed_wrong_ = false;
    }

    void position(const Truth& truth, const mavlink::GlobalPositionInt& reported, double now_s,
                  const Report& report) const {
        if (reported.lat == 0 && reported.lon == 0) return;  // not known
        const double north_m = (reported.lat - truth.latitude_deg * 1e7) * kMetresPerE7;
        const double east_m = (reported.lon - truth.longitude_deg * 1e7) * kMetresPerE7 *
                              std::cos(truth.latitude_deg * kDegree);
        const double away_m = std::hypot(north_m, east_m);
        const double speed_mps = std::hypot(reported.vx, reported.vy) * 0.01;
        const double height_m = reported.alt * 0.001 - truth.altitude_m;
        if (away_m > kAway_m) report(now_s, text("%.0f m from where it stands", away_m));
        if (speed_mps > kSpeed_mps) report(now_s, text("%.1f m/s over ground", speed_mps));
        if (std::abs(height_m) > kHeight_m && !zeroed_wrong_)
            report(now_s, text("%.0f m too high", height_m));
    }
    static void airspeed(const Truth& truth, const mavlink::VfrHud& reported, double now_s,
                         const Report& report) {
        const double more_mps = double(reported.airspeed) - truth.equivalent_airspeed_mps;
        if (more_mps > kAirspeed_mps)
            report(now_s, text("an airspeed of %.1f m/s, the air moves at %.1f m/s",
                               double(reported.airspeed), truth.equivalent_airspeed_mps));
    }

    double unsettled_s_ = 0;
    bool zeroed_wrong_ = false;
};

}  // namespace

std::unique_ptr<Invariant> standsStill() { return std::make_unique<StandsStill>(); }

}  // namespace simulator::invariants
