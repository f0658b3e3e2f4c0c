// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/ground/scripted_flight.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "simulator/devices/ppm_encoder.hpp"
#include "simulator/ground/landing_check.hpp"

namespace simulator {

using namespace mavlink;

constexpr double kNever = 1e9;
constexpr double kStanding_mps = 0.5;
constexpr double kAtRest_s = 2;         // standing: it has rolled out
constexpr double kDisarmWithin_s = 60;  // LAND_DISARMDELAY is 20 s
constexpr double kLastWords_s = 3;
constexpr double kSilence_s = 10;
constexpr uint16_t kStreams_hz = 10;
constexpr char kCruiseSpeed[] = "TRIM_ARSPD_CM", kLoiterRadius[] = "WP_LOITER_RAD";

const ScriptedFlight::Stage ScriptedFlight::kStages[] = {
    {&ScriptedFlight::connect, 60, "no heartbeat from the autopilot"},
    {&ScriptedFlight::agreeOnFraming, 30, "the autopilot does not answer"},
    {&ScriptedFlight::setParameters, 120, "the parameters were not set"},
    {&ScriptedFlight::requestStreams, 20, "the autopilot sends no telemetry streams"},
    {&ScriptedFlight::upload, 120, "the mission upload did not end"},
    {&ScriptedFlight::uploadFence, 60, "the upload of the fence did not end"},
    {&ScriptedFlight::uploadRally, 60, "the upload of the rally points did not end"},
    {&ScriptedFlight::waitReady, 120, "not ready to arm"},
    {&ScriptedFlight::arm, 60, "arming is refused"},
    {&ScriptedFlight::setAuto, 20, "AUTO is refused"},
    {&ScriptedFlight::release, 10, ""},
    {&ScriptedFlight::takeOff, 60, "the airplane did not leave the ground"},
    {&ScriptedFlight::fly, kNever, ""},
};

void switchTransmitterOn(World& world) {
    world.radio().sticks({1500, 1500, 1100, 1500, 1500, 1500, 1500, 1425}, true);
}

ScriptedFlight::ScriptedFlight(Board& board, int usart, const MissionFile& mission,
                               double time_limit_s, const ParameterSettings& settings)
    : board_(board),
      items_(mission.items),
      fence_(fenceItems(mission.fence)),
      rally_(rallyItems(mission.rally)),
      stored_navs_(mission.stored_navs),
      frame_(items_[0].latitude_deg, items_[0].longitude_deg),
      plan_(makePlan(items_, frame_)),
      time_limit_s_(time_limit_s),
      link_(board, usart, [this](const Frame& frame, uint64_t time_us) { take(frame, time_us); }),
      parameters_(link_, settings),
      upload_(link_, items_),
      fence_upload_(link_, fence_, UploadOf::fence),
      rally_upload_(link_, rally_, UploadOf::rally) {}

void ScriptedFlight::take(const Frame& frame, uint64_t time_us) {
    telemetry_.take(frame, time_us);
    parameters_.take(frame);
    upload_.take(frame, time_us);
    fence_upload_.take(frame, time_us);
    rally_upload_.take(frame, time_us);
    if (auto value = as<ParamValue>(frame)) {
        const std::string name(value->param_id, strnlen(value->param_id, sizeof value->param_id));
        if (name == kCruiseSpeed) cruise_speed_mps_ = value->param_value * 0.01;
        if (name == kLoiterRadius) loiter_radius_m_ = double{value->param_value};
    }
    if (auto ack = as<CommandAck>(frame)) {
        last_answer_ = "command " + std::to_string(ack->command) + " answered with result " +
                       std::to_string(ack->result);
    }
}

void ScriptedFlight::step(uint64_t now_us) {
    if (over_) return;
    heartbeat(now_us);
    watch(now_us);
    const Stage& stage = kStages[stage_];
    if (!over_ && (this->*stage.run)(now_us)) {
        if (&stage == &std::end(kStages)[-1]) {
            check();
            over_ = true;
            return;
        }
        ++stage_;
        tries_ = 0;
        stage_us_ = now_us;
    } else if (!over_ && static_cast<double>(now_us - stage_us_) * 1e-6 > stage.time_out_s) {
        std::string why = stage.failure;
        why += " within " + std::to_string(static_cast<int>(stage.time_out_s)) + " s";
        if (!telemetry_.texts.empty()) why += "; it said: " + telemetry_.texts.back().text;
        fail(why);
    }
}

void ScriptedFlight::fail(const std::string& reason) {
    over_ = true;
    reason_ = reason;
}

void ScriptedFlight::heartbeat(uint64_t now_us) {
    if (beat_us_ != 0 && now_us - beat_us_ < 1'000'000) return;
    beat_us_ = now_us;
    Heartbeat beat{};
    beat.type = MavType::gcs;
    beat.autopilot = MavAutopilot::invalid;
    beat.system_status = MavState::active;
    beat.mavlink_version = 3;
    link_.send(beat);
}

// True at the first call of a stage and then once in `seconds`; counts in tries_.
bool ScriptedFlight::every(double seconds, uint64_t now_us) {
    if (tries_ > 0 && static_cast<double>(now_us - sent_us_) * 1e-6 < seconds) return false;
    sent_us_ = now_us;
    ++tries_;
    return true;
}

void ScriptedFlight::command(uint16_t number, float param1, float param2) {
    CommandLong message{};
    message.command = number;
    message.param1 = param1;
    message.param2 = param2;
    message.target_system = telemetry_.system;
    message.target_component = telemetry_.component;
    message.confirmation = static_cast<uint8_t>(tries_ - 1);
    link_.send(message);
}

bool ScriptedFlight::connect(uint64_t) { return telemetry_.heard(); }

// MAVLink 2 first, as today's ground stations do; an autopilot that stays silent is asked again
// in MAVLink 1. The question is one whose answer is of use: the cruise speed.
bool ScriptedFlight::agreeOnFraming(uint64_t now_us) {
    if (cruise_speed_mps_) return true;
    if (!every(1.5, now_us)) return tries_ > 8;
    if (tries_ > 3) link_.setFraming(Framing::v1);
    askFor(kCruiseSpeed);
    return false;
}

void ScriptedFlight::askFor(const char* parameter) {
    ParamRequestRead request{};
    request.param_index = -1;
    request.target_system = telemetry_.system;
    request.target_component = telemetry_.component;
    std::memcpy(request.param_id, parameter, strnlen(parameter, sizeof request.param_id));
    link_.send(request);
}

bool ScriptedFlight::setParameters(uint64_t now_us) {
    parameters_.step(now_us, telemetry_.system, telemetry_.component);
    if (!parameters_.failure().empty()) fail(parameters_.failure());
    return parameters_.done();
}

bool ScriptedFlight::requestStreams(uint64_t now_us) {
    if (telemetry_.hud && telemetry_.attitude && telemetry_.position) return true;
    if (!every(2, now_us)) return false;
    RequestDataStream request{};
    request.req_message_rate = kStreams_hz;
    request.target_system = telemetry_.system;
    request.target_component = telemetry_.component;
    request.req_stream_id = MavDataStream::all;
    request.start_stop = 1;
    link_.send(request);
    return false;
}

bool ScriptedFlight::send(MissionUpload& upload, const char* said, uint64_t now_us) {
    upload.step(now_us, telemetry_.system, telemetry_.component);
    if (!upload.failure().empty()) fail(upload.failure());
    if (upload.accepted()) telemetry_.note(now_us, said);
    return upload.accepted();
}

bool ScriptedFlight::upload(uint64_t now_us) {
    return !stored_navs_.empty() || send(upload_, "mission uploaded", now_us);
}

bool ScriptedFlight::uploadFence(uint64_t now_us) {
    return fence_.empty() || send(fence_upload_, "fence uploaded", now_us);
}

bool ScriptedFlight::uploadRally(uint64_t now_us) {
    return rally_.empty() || send(rally_upload_, "rally points uploaded", now_us);
}

// Meanwhile the radius of circles is asked for, which the report draws.
bool ScriptedFlight::waitReady(uint64_t now_us) {
    constexpr uint8_t kFix3d = 3;
    if (!loiter_radius_m_ && tries_ < 3 && every(1, now_us)) askFor(kLoiterRadius);
    return telemetry_.prearmOk() && telemetry_.gps && telemetry_.gps->fix_type >= kFix3d;
}

bool ScriptedFlight::arm(uint64_t now_us) {
    if (telemetry_.armed()) return true;
    if (every(3, now_us)) command(MavCmd::component_arm_disarm, 1, 0);
    return false;
}

// By command and by message in turn: older autopilots know the message alone.
void ScriptedFlight::orderAuto() {
    if (tries_ % 2 == 1)
        return command(MavCmd::do_set_mode, MavModeFlag::custom_mode_enabled, kModeAuto);
    SetMode message{};
    message.custom_mode = kModeAuto;
    message.target_system = telemetry_.system;
    message.base_mode = MavModeFlag::custom_mode_enabled;
    link_.send(message);
}

bool ScriptedFlight::setAuto(uint64_t now_us) {
    if (telemetry_.mode() == kModeAuto) return true;
    if (every(2, now_us)) orderAuto();
    return false;
}

// A thrower waits a moment; an airplane on wheels rolls without him.
bool ScriptedFlight::release(uint64_t now_us) {
    constexpr uint64_t kMoment_us = 1'000'000;
    if (now_us - stage_us_ < kMoment_us) return false;
    board_.world().launch();
    return true;
}

bool ScriptedFlight::takeOff(uint64_t) { return airborne_s_.has_value(); }

// Over when it has come to rest and is disarmed, and has had the time to report it, whatever a gust
// does to it since. Some never disarm by themselves.
bool ScriptedFlight::fly(uint64_t now_us) {
    const double now_s = static_cast<double>(now_us) * 1e-6;
    if (telemetry_.armed()) disarmed_s_.reset();
    if (disarmed_s_) return now_s - *disarmed_s_ > kLastWords_s;
    if (standing_s_ && now_s - *standing_s_ > kAtRest_s) came_to_rest_ = true;
    if (!telemetry_.armed()) {
        if (came_to_rest_) disarmed_s_ = now_s;
        return false;
    }
    const bool late = standing_s_ && now_s - *standing_s_ > kDisarmWithin_s;
    if (late && !another_) fail("it stands, but does not disarm");
    return late && another_;
}

void ScriptedFlight::watch(uint64_t now_us) {
    constexpr double kAirborne_m = 2;
    const Truth& truth = board_.world().truth();
    const double now_s = static_cast<double>(now_us) * 1e-6;
    watchServos(now_us);
    if (truth.height_m > kAirborne_m && !truth.on_ground) {
        if (!airborne_s_) telemetry_.note(now_us, "airborne");
        if (!airborne_s_) airborne_s_ = now_s;
        landed_s_.reset();
        came_to_rest_ = false;
    } else if (airborne_s_ && !landed_s_ && truth.on_ground) {
        landed_s_ = now_s;
        touchdown_m_ = fromLanding_m();
        touchdown_sink_mps_ = sink_mps_;
        telemetry_.note(now_us, "touchdown");
    }
    if (!truth.on_ground) sink_mps_ = truth.velocity_down_mps;
    const double speed = std::hypot(truth.velocity_north_mps, truth.velocity_east_mps);
    if (!airborne_s_ || !truth.on_ground || speed > kStanding_mps) {
        standing_s_.reset();
    } else if (!standing_s_) {
        standing_s_ = now_s;
    }
    const std::string where = " after item " + std::to_string(telemetry_.current());
    if (truth.crashed && !disarmed_s_) fail("crashed" + where);
    if (now_s > time_limit_s_) fail("time limit reached" + where);
    if (telemetry_.heard() &&
        static_cast<double>(now_us - telemetry_.heartbeat_us) * 1e-6 > kSilence_s) {
        fail("no heartbeat for 10 s" + where);
    }
}

// Outputs 5..8 are the mission's to set; a jump of the pulse is an event.
void ScriptedFlight::watchServos(uint64_t now_us) {
    for (int output = 5; output <= 8; ++output) {
        double& last = servo_us_[static_cast<size_t>(output - 1)];
        const double pulse = std::round(board_.world().servoPulse_us(output));
        if (telemetry_.mode() == kModeAuto && std::abs(pulse - last) > 5) {
            telemetry_.note(now_us, "servo " + std::to_string(output) + " to " +
                                        std::to_string(static_cast<int>(pulse)) + " us");
        }
        last = pulse;
    }
}

std::optional<double> ScriptedFlight::fromLanding_m() const {
    if (!plan_.landing()) return std::nullopt;
    const Truth& truth = board_.world().truth();
    return distance_m(*plan_.landing(), frame_.at(truth.latitude_deg, truth.longitude_deg));
}

std::optional<double> ScriptedFlight::standing_distance_m() const {
    return standing_s_ ? fromLanding_m() : std::nullopt;
}

// Says in reason_ what is missing for a completed mission; nothing when it is one.
void ScriptedFlight::check() {
    const std::vector<int> wanted = stored_navs_.empty() ? navsInTurn(items_) : stored_navs_;
    // Firmware that does not send MISSION_ITEM_REACHED shows its way by MISSION_CURRENT.
    const auto& flown = telemetry_.reached.empty() ? telemetry_.visited : telemetry_.reached;
    if (flown != wanted) {
        const auto differ = std::mismatch(wanted.begin(), wanted.end(), flown.begin(), flown.end());
        reason_ = differ.first == wanted.end()
                      ? "more items were reached than the mission has"
                      : "item " + std::to_string(*differ.first) + " was not reached in its turn";
    } else {
        checkLanding();
    }
}

void ScriptedFlight::checkLanding() {
    reason_ = plan_.landing() ? landingFault(touchdown_m_, *fromLanding_m())
                              : "the mission has no landing to check";
}

}  // namespace simulator
