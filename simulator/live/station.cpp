// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/live/station.hpp"

#include <cmath>
#include <limits>

namespace simulator::live {
namespace {

using namespace mavlink;

constexpr uint8_t kComponent = 25;  // MAV_COMP_ID_USER1: what is meant for it is not the user's
constexpr uint64_t kAskAgain_us = 3'000'000, kAnswerWithin_us = 1'500'000;
constexpr uint64_t kTextsWithin_us = 200'000;    // of the answer they belong to
constexpr uint64_t kShownWithin_us = 1'500'000;  // heartbeats come once a second
constexpr int kTries = 3;
constexpr uint16_t kStreams_hz = 10;
constexpr float kStay = std::numeric_limits<float>::quiet_NaN();
constexpr const char* kParameters[] = {"TRIM_ARSPD_CM", "WP_LOITER_RAD"};

void addText(std::string& all, const std::string& text) { all += (all.empty() ? "" : "; ") + text; }

}  // namespace

std::string resultName(uint8_t result) {
    static constexpr const char* kNames[] = {"ACCEPTED",         "TEMPORARILY_REJECTED",
                                             "DENIED",           "UNSUPPORTED",
                                             "FAILED",           "IN_PROGRESS",
                                             "CANCELLED",        "COMMAND_LONG_ONLY",
                                             "COMMAND_INT_ONLY", "COMMAND_UNSUPPORTED_MAV_FRAME"};
    return result < std::size(kNames) ? kNames[result] : "result " + std::to_string(result);
}

Station::Station(Board& board, int usart)
    : link_(board, usart, [this](const Frame& frame, uint64_t time_us) { take(frame, time_us); }),
      plans_(link_) {
    link_.setComponent(kComponent);
}

std::optional<double> Station::parameter(const std::string& name) const {
    const auto found = parameters_.find(name);
    if (found == parameters_.end()) return std::nullopt;
    return found->second;
}

void Station::take(const Frame& frame, uint64_t time_us) {
    telemetry_.take(frame, time_us);
    plans_.take(frame, time_us);
    if (upload_) upload_->take(frame, time_us);
    overhear(frame);
    if (frame.id == Wire<Attitude>::id) attitude_us_ = time_us;
    if (const auto ack = as<CommandAck>(frame)) takeAck(*ack, time_us);
    if (const auto text = as<Statustext>(frame)) takeText(*text, time_us);
    if (const auto value = as<ParamValue>(frame)) {
        const std::string name(value->param_id, strnlen(value->param_id, sizeof value->param_id));
        parameters_[name] = double{value->param_value};
    }
}

void Station::overhear(const Frame& frame) {
    constexpr uint8_t kAccepted = 0, kAll = 255;
    const auto ack = as<MissionAck>(frame);
    if (!ack || ack->type != kAccepted) return;
    if (ack->mission_type == kAll) plans_.askAgain();
    if (ack->mission_type < kLists) plans_.askAgain(ack->mission_type);
}

void Station::takeAck(const CommandAck& ack, uint64_t time_us) {
    if (commands_.empty()) return;
    Command& command = commands_.front();
    if (command.tries == 0 || command.result || ack.command != command.number) return;
    if (ack.result == MavResult::in_progress) return;
    command.result = ack.result;
    command.answered_us = time_us;
}

void Station::takeText(const Statustext& text, uint64_t time_us) {
    on_text(text, time_us);
    if (commands_.empty() || commands_.front().tries == 0) return;
    addText(commands_.front().texts, std::string(text.text, strnlen(text.text, sizeof text.text)));
}

// On arming home is where the airplane stands; what older ways have changed is read then, too.
void Station::step(uint64_t now_us) {
    if (!telemetry_.heard()) return;
    if (telemetry_.armed() != was_armed_) plans_.askAgain();
    was_armed_ = telemetry_.armed();
    askForStreams(now_us);
    askForParameters(now_us);
    if (upload_) {
        runUpload(now_us);
    } else {
        plans_.step(now_us, telemetry_.system, telemetry_.component);
    }
    runCommand(now_us);
}

void Station::askForStreams(uint64_t now_us) {
    const bool come = attitude_us_ != 0 && now_us - attitude_us_ < kAskAgain_us;
    const bool asked = streams_asked_us_ != 0 && now_us - streams_asked_us_ < kAskAgain_us;
    if (come || asked) return;
    streams_asked_us_ = now_us;
    RequestDataStream request{};
    request.req_message_rate = kStreams_hz;
    request.target_system = telemetry_.system;
    request.target_component = telemetry_.component;
    request.req_stream_id = MavDataStream::all;
    request.start_stop = 1;
    link_.send(request);
}

void Station::askForParameters(uint64_t now_us) {
    if (parameters_asked_us_ != 0 && now_us - parameters_asked_us_ < kAskAgain_us) return;
    parameters_asked_us_ = now_us;
    for (const char* name : kParameters) {
        if (parameters_.count(name) > 0) continue;
        ParamRequestRead request{};
        request.param_index = -1;
        request.target_system = telemetry_.system;
        request.target_component = telemetry_.component;
        std::memcpy(request.param_id, name, strnlen(name, sizeof request.param_id));
        link_.send(request);
    }
}

void Station::give(const Order& order, Answer answer) {
    if (!telemetry_.heard()) return answer(false, "nothing has been heard of the autopilot yet");
    switch (order.what) {
        case Order::Do::arm:
        case Order::Do::disarm:
            return arm(order.what == Order::Do::arm, std::move(answer));
        case Order::Do::mode:
            return setMode(order.mode, std::move(answer));
        case Order::Do::go_to:
            return goTo(order, std::move(answer));
        case Order::Do::takeoff:
            return takeOff(std::move(answer));
        default:
            return answer(false, "this is no command for the autopilot");
    }
}

void Station::arm(bool armed, Answer answer) {
    command(MavCmd::component_arm_disarm, {armed ? 1.0f : 0.0f, 0}, std::move(answer),
            [this, armed] { return telemetry_.armed() == armed; });
}

void Station::setMode(uint32_t mode, Answer answer) {
    command(MavCmd::do_set_mode, {MavModeFlag::custom_mode_enabled, static_cast<float>(mode)},
            std::move(answer), [this, mode] { return telemetry_.mode() == mode; });
}

void Station::command(uint16_t number, std::array<float, 2> params, Answer answer,
                      std::function<bool()> shows) {
    const auto send = [this, number, params](uint8_t confirmation) {
        CommandLong message{};
        message.command = number;
        message.param1 = params[0];
        message.param2 = params[1];
        message.target_system = telemetry_.system;
        message.target_component = telemetry_.component;
        message.confirmation = confirmation;
        link_.send(message);
    };
    commands_.push_back({send, number, std::move(answer), std::move(shows)});
}

// As QGroundControl's "go to location": GUIDED, speed and circle as they are.
void Station::goTo(const Order& order, Answer answer) {
    constexpr float kAsItIs = -1, kChangeMode = 1;  // MAV_DO_REPOSITION_FLAGS
    const auto send = [this, order](uint8_t) {
        CommandInt message{};
        message.command = MavCmd::do_reposition;
        message.frame = MavFrame::global_relative_alt_int;
        message.param1 = kAsItIs;
        message.param2 = kChangeMode;
        message.param3 = message.param4 = kStay;
        message.x = static_cast<int32_t>(std::lround(order.latitude_deg * 1e7));
        message.y = static_cast<int32_t>(std::lround(order.longitude_deg * 1e7));
        message.z = order.height_m ? static_cast<float>(*order.height_m) : kStay;
        message.target_system = telemetry_.system;
        message.target_component = telemetry_.component;
        link_.send(message);
    };
    commands_.push_back({send, MavCmd::do_reposition, std::move(answer)});
}

void Station::runCommand(uint64_t now_us) {
    if (commands_.empty()) return;
    Command& command = commands_.front();
    if (command.result) {
        const bool ok = *command.result == MavResult::accepted;
        const uint64_t since_us = now_us - command.answered_us;
        const bool waits = ok && command.shows && !command.shows() && since_us < kShownWithin_us;
        if (waits || since_us < kTextsWithin_us) return;
        return finish(
            ok, resultName(*command.result) + (command.texts.empty() ? "" : ": " + command.texts));
    }
    if (command.tries > 0 && now_us - command.sent_us < kAnswerWithin_us) return;
    if (command.tries == kTries) return finish(false, "the autopilot does not answer");
    command.sent_us = now_us;
    command.send(static_cast<uint8_t>(command.tries++));
}

void Station::finish(bool ok, const std::string& text) {
    const Answer answer = std::move(commands_.front().answer);
    commands_.pop_front();
    answer(ok, text);
}

bool Station::beginsWithTakeoff() const {
    for (const WaypointItem& item : plans_.items(0))
        if (item.index > 0 && item.isNav()) return item.command == MavCmd::nav_takeoff;
    return false;
}

// The take-off is an item of a mission. A board without a mission is given one of a take-off and
// a circle above home, as the user of a ground station would; another mission is left alone.
void Station::takeOff(Answer answer) {
    if (!telemetry_.armed()) return answer(false, "not armed");
    if (!plans_.known(0)) return answer(false, "the board's mission has not been read yet");
    if (upload_) return answer(false, "the upload of a mission is under way");
    if (beginsWithTakeoff()) return command(MavCmd::mission_start, {0, 0}, std::move(answer));
    if (plans_.items(0).size() > 1)
        return answer(false, "the mission on the board does not begin with a take-off");
    uploadTakeoff(std::move(answer));
}

void Station::uploadTakeoff(Answer answer) {
    constexpr double kPitch_deg = 15, kClimb_m = 50, kCircle_m = 60;
    if (!telemetry_.position) return answer(false, "the autopilot does not report its position");
    WaypointItem home, takeoff, circle;
    home.command = MavCmd::nav_waypoint;
    home.latitude_deg = telemetry_.position->lat * 1e-7;
    home.longitude_deg = telemetry_.position->lon * 1e-7;
    home.altitude_m = telemetry_.position->alt * 1e-3;
    takeoff.index = 1;
    takeoff.command = MavCmd::nav_takeoff;
    takeoff.params[0] = kPitch_deg;
    takeoff.altitude_m = kClimb_m;
    circle = home;
    circle.index = 2;
    circle.command = MavCmd::nav_loiter_unlim;
    circle.altitude_m = kCircle_m;
    takeoff.frame = circle.frame = MavFrame::global_relative_alt;
    upload_items_ = {home, takeoff, circle};
    upload_ = std::make_unique<MissionUpload>(link_, upload_items_);
    upload_answer_ = std::move(answer);
}

void Station::runUpload(uint64_t now_us) {
    upload_->step(now_us, telemetry_.system, telemetry_.component);
    const std::string failure = upload_->failure();
    if (failure.empty() && !upload_->accepted()) return;
    upload_.reset();
    Answer answer = std::move(upload_answer_);
    if (!failure.empty()) return answer(false, failure);
    command(MavCmd::mission_start, {0, 0}, std::move(answer));
}

}  // namespace simulator::live
