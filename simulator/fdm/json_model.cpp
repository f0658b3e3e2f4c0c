// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/fdm/json_model.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <sstream>
#include <utility>

#include "simulator/airplane/atmosphere.hpp"
#include "simulator/airplane/earth.hpp"

namespace simulator {
namespace {

using Clock = std::chrono::steady_clock;

constexpr uint64_t kStep_us = 2500;
constexpr uint16_t kRate_hz = 400;
constexpr double kStep_s = 1.0 / kRate_hz;
constexpr double kLongestStep_s = 1;  // more is a model that was begun anew
constexpr double kSilence_s = 10;     // in the middle of a flight
constexpr auto kAgain = std::chrono::milliseconds(1000), kMaxAgain = 5 * kAgain;
constexpr int kMaxSkipped = 1000;        // answers in a row
constexpr int kMaxStandstills = 10'000;  // answers without a newer timestamp
constexpr int kMaxBegunAnew = 100;       // in a row: no program is begun that often
constexpr double kWheels_m = 0.3;        // standing on the ground is not higher
constexpr double kFullBattery_v = 12.4;
constexpr double kIdle_us = 1100, kFull_us = 1900;

ModelAddress addressIn(const WorldOptions& options) {
    const auto address = modelAddress(options.fdm);
    if (!address) throw UdpError("no flight model is called " + options.fdm);
    return *address;
}

std::array<uint16_t, kPacketPulses> packed(const ServoPulses& pulses) {
    std::array<uint16_t, kPacketPulses> out{};
    for (size_t i = 0; i < pulses.width_us.size(); ++i)
        out[i] = static_cast<uint16_t>(pulses.width_us[i] + 0.5);
    return out;
}

}  // namespace

std::optional<ModelAddress> modelAddress(const std::string& text) {
    constexpr char kKind[] = "json:";
    if (text.rfind(kKind, 0) != 0) return std::nullopt;
    const std::string rest = text.substr(sizeof kKind - 1);
    const size_t colon = rest.rfind(':');
    const std::string host = colon == rest.npos ? "127.0.0.1" : rest.substr(0, colon);
    const std::string port = colon == rest.npos ? rest : rest.substr(colon + 1);
    constexpr size_t kMaxDigits = 5;
    if (host.empty() || port.empty() || port.size() > kMaxDigits ||
        port.find_first_not_of("0123456789") != port.npos)
        return std::nullopt;
    const long number = std::stol(port);
    if (number < 1 || number >= UINT16_MAX) return std::nullopt;  // ours is the next one
    return ModelAddress{host, static_cast<uint16_t>(number)};
}

// Until it is heard the airplane stands level at home.
JsonModel::JsonModel(const WorldOptions& options)
    : options_(options),
      name_("the flight model at " + options.fdm.substr(sizeof "json:" - 1)),
      peer_(addressIn(options).host, addressIn(options).port,
            static_cast<uint16_t>(addressIn(options).port + 1)),
      again_(kAgain) {
    ModelState standing;
    standing.force_mss = {0, 0, -kGravity_mss};
    standing.attitude = quaternion(0, 0, options.heading_deg * M_PI / 180);
    publish(standing);
}

void JsonModel::stop(const std::string& why) { fault_ = name_ + ": " + why; }

// One datagram that makes no sense is lost, as on any network; a model that sends nothing else is
// no model.
bool JsonModel::understand(const std::string& datagram, ModelState& to) {
    try {
        to = readModelState(datagram);
        skipped_in_a_row_ = 0;
        return true;
    } catch (const ModelStateError& error) {
        ++skipped_;
        complaint_ = error.what();
        if (++skipped_in_a_row_ == kMaxSkipped)
            stop(std::to_string(kMaxSkipped) + " answers that make no sense: " + complaint_);
        return false;
    }
}

// Counted on, also when asked again: models take a packet of the same number for a copy.
void JsonModel::ask(const ServoPulses& pulses) {
    peer_.send(servoPacket(kRate_hz, ++frames_, packed(pulses)));
}

// Asked again and again for as long as there is to wait, for a program that starts later.
bool JsonModel::exchange(const ServoPulses& pulses, ModelState& to) {
    const std::chrono::duration<double> longest(heard_ ? kSilence_s : options_.fdm_wait_s);
    const auto end = Clock::now() + std::chrono::ceil<Clock::duration>(longest);
    bool reported = heard_, repeated = false;
    peer_.newest();  // what came late answers no question any more
    while (fault_.empty() && Clock::now() < end) {
        if (heard_ && std::exchange(repeated, true)) askLessOften();
        ask(pulses);
        const auto rest = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now());
        if (peer_.wait(std::min(again_, rest)) == UdpPeer::Waited::interrupted) {
            stop("interrupted while waiting for it");
            return false;
        }
        const auto newest = peer_.newest();
        if (newest && understand(*newest, to)) return true;
        if (!newest && !std::exchange(reported, true))
            std::cout << "waiting for " << name_ << std::endl;
    }
    if (fault_.empty())
        stop("no answer for " + std::to_string(std::lround(longest.count())) + " s" +
             (skipped_in_a_row_ > 0 ? " that makes sense: " + complaint_ : ""));
    return false;
}

// Questions that a slow model has not come to yet wait in its socket, and each is another step.
void JsonModel::askLessOften() {
    if (again_ == kAgain)
        std::cout << name_ << " is slow: no answer for " << kAgain.count() << " ms" << std::endl;
    again_ = std::min(2 * again_, kMaxAgain);
}

void JsonModel::step(const ServoPulses& pulses) {
    truth_.throttle = std::clamp((pulses.width_us[2] - kIdle_us) / (kFull_us - kIdle_us), 0.0, 1.0);
    ModelState state;
    for (int tries = 0; fault_.empty(); ++tries) {
        if (!exchange(pulses, state)) break;
        if (!heard_ || state.timestamp_s != last_timestamp_s_) {
            take(state);
            return;
        }
        if (tries == kMaxStandstills) stop("its timestamp stands still");
    }
    truth_.time_us += kStep_us;  // the board's time goes on, to its end
}

// A timestamp from before, or from long after: it was begun anew, and goes on from here.
void JsonModel::beginAnew(double gone_s) {
    ++begun_anew_;
    if (++begun_anew_in_a_row_ < kMaxBegunAnew) return;
    std::ostringstream steps;
    steps << (gone_s < 0 ? "back by " : "on by ") << std::abs(gone_s);
    stop("its timestamp goes " + steps.str() + " s with every answer; expected up to 1 s on");
}

void JsonModel::take(const ModelState& state) {
    const double gone_s = state.timestamp_s - last_timestamp_s_;
    const bool follows = heard_ && gone_s > 0 && gone_s <= kLongestStep_s;
    if (follows) begun_anew_in_a_row_ = 0;
    if (heard_ && !follows) beginAnew(gone_s);
    if (!heard_) standing_down_m_ = state.position_m.z;
    const double step_s = follows ? gone_s : kStep_s;
    elapsed_s_ += step_s;
    last_timestamp_s_ = state.timestamp_s;
    heard_ = true;
    publish(state);
    truth_.time_us = static_cast<uint64_t>(elapsed_s_ * 1e6 + 0.5);
    truth_.battery_used_mah += truth_.motor_current_a * step_s / 3.6;
    if (state.radio_us) moveSticks(*state.radio_us);
}

// A channel that is not sent stays where it was; at first they are where a pilot leaves them.
void JsonModel::moveSticks(const std::array<uint16_t, 8>& sent_us) {
    if (!radio_us_) radio_us_ = {1500, 1500, 1100, 1500, 1500, 1500, 1500, 1425};
    for (size_t i = 0; i < sent_us.size(); ++i)
        if (sent_us[i] != 0) (*radio_us_)[i] = sent_us[i];
}

void JsonModel::publish(const ModelState& state) {
    attitude_ = state.attitude;
    const Rotation rotation(attitude_);
    Truth& t = truth_;
    t.north_m = state.position_m.x;
    t.east_m = state.position_m.y;
    t.height_m = standing_down_m_ - state.position_m.z;
    t.altitude_m = options_.altitude_m + t.height_m;
    const Place place =
        moved({options_.latitude_deg, options_.longitude_deg}, t.altitude_m, t.north_m, t.east_m);
    t.latitude_deg = place.latitude_deg;
    t.longitude_deg = place.longitude_deg;
    t.velocity_north_mps = state.velocity_mps.x;
    t.velocity_east_mps = state.velocity_mps.y;
    t.velocity_down_mps = state.velocity_mps.z;
    t.roll_rad = rotation.roll_rad();
    t.pitch_rad = rotation.pitch_rad();
    t.yaw_rad = rotation.yaw_rad();
    t.roll_rate_rads = state.rates_rads.x;
    t.pitch_rate_rads = state.rates_rads.y;
    t.yaw_rate_rads = state.rates_rads.z;
    t.force_x_mss = state.force_mss.x;
    t.force_y_mss = state.force_mss.y;
    t.force_z_mss = state.force_mss.z;
    const Vec3 through = rotation.toBody(state.velocity_mps - state.wind_mps);
    t.airspeed_mps = state.airspeed_mps.value_or(length(through));
    t.equivalent_airspeed_mps =
        t.airspeed_mps * std::sqrt(atmosphere(t.altitude_m).density_kgm3 / kSeaLevelDensity_kgm3);
    t.alpha_rad = std::atan2(through.z, through.x);
    t.beta_rad = std::atan2(through.y, std::hypot(through.x, through.z));
    t.wind_north_mps = state.wind_mps.x;
    t.wind_east_mps = state.wind_mps.y;
    t.wind_down_mps = state.wind_mps.z;
    t.battery_v = state.battery ? state.battery->voltage_v : kFullBattery_v;
    t.motor_current_a = state.battery ? state.battery->current_a : 0;
    t.on_ground = t.height_m < kWheels_m;
}

}  // namespace simulator
