// SPDX-License-Identifier: GPL-3.0-or-later
// A flight from the ground station's chair: connect, set the airplane's parameters, send the
// mission up with its fence and rally points, arm, AUTO, let go of what is thrown, watch until the
// airplane stands again. What only a ground station can know, where it stands and whether it
// crashed, is read from the truth.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "simulator/ground/link.hpp"
#include "simulator/ground/mission_file.hpp"
#include "simulator/ground/mission_upload.hpp"
#include "simulator/ground/parameter_upload.hpp"
#include "simulator/ground/plan.hpp"
#include "simulator/ground/telemetry.hpp"
#include "simulator/ground/waypoints.hpp"

namespace simulator {

// The pilot beside the runway: transmitter on, sticks centred, throttle closed, mode switch on
// FBWA (third position of FLTMODE), ready to take over.
void switchTransmitterOn(World& world);

class ScriptedFlight {
public:
    ScriptedFlight(Board& board, int usart, const MissionFile& mission, double time_limit_s,
                   const ParameterSettings& settings = {});
    ScriptedFlight(Board& board, int usart, const Waypoints& items, double time_limit_s,
                   const ParameterSettings& settings = {})
        : ScriptedFlight(board, usart, MissionFile{items, {}, {}, {}, {}, {}}, time_limit_s,
                         settings) {}

    void receive(uint8_t byte, uint64_t time_us) { link_.receive(byte, time_us); }
    void step(uint64_t now_us);  // every 20 ms or so

    void stop(const std::string& reason) { fail(reason); }  // it cannot go on
    // Another firmware than ours: it need not disarm when it stands.
    void flyAnother() { another_ = true; }

    bool over() const { return over_; }
    bool completed() const { return over_ && reason_.empty(); }
    const std::string& reason() const { return reason_; }  // why it was not completed, one line
    const Telemetry& telemetry() const { return telemetry_; }
    std::optional<double> cruise_speed_mps() const { return cruise_speed_mps_; }
    std::optional<double> loiter_radius_m() const { return loiter_radius_m_; }
    std::optional<double> airborne_s() const { return airborne_s_; }  // first time off the ground
    std::optional<double> landed_s() const { return landed_s_; }      // touched down for good
    std::optional<double> touchdown_distance_m() const { return touchdown_m_; }
    std::optional<double> touchdown_sink_mps() const { return touchdown_sink_mps_; }
    std::optional<double> standing_distance_m() const;  // of where it is now

private:
    struct Stage {
        bool (ScriptedFlight::*run)(uint64_t now_us);
        double time_out_s;
        const char* failure;
    };
    static const Stage kStages[];

    bool connect(uint64_t now_us);
    bool agreeOnFraming(uint64_t now_us);
    bool requestStreams(uint64_t now_us);
    bool setParameters(uint64_t now_us);
    bool upload(uint64_t now_us);
    bool uploadFence(uint64_t now_us);
    bool uploadRally(uint64_t now_us);
    bool send(MissionUpload& upload, const char* said, uint64_t now_us);
    bool waitReady(uint64_t now_us);
    bool arm(uint64_t now_us);
    bool setAuto(uint64_t now_us);
    bool release(uint64_t now_us);
    bool takeOff(uint64_t now_us);
    bool fly(uint64_t now_us);

    void take(const mavlink::Frame& frame, uint64_t time_us);
    void watch(uint64_t now_us);
    void watchServos(uint64_t now_us);
    void check();
    void checkLanding();
    std::optional<double> fromLanding_m() const;
    void fail(const std::string& reason);
    void heartbeat(uint64_t now_us);
    bool every(double seconds, uint64_t now_us);
    void command(uint16_t number, float param1, float param2);
    void orderAuto();
    void askFor(const char* parameter);

    Board& board_;
    const Waypoints items_, fence_, rally_;
    const std::vector<int> stored_navs_;
    const LocalFrame frame_;
    const Plan plan_;
    const double time_limit_s_;
    Link link_;
    Telemetry telemetry_;
    ParameterUpload parameters_;
    MissionUpload upload_, fence_upload_, rally_upload_;
    int stage_ = 0;
    uint64_t stage_us_ = 0, sent_us_ = 0, beat_us_ = 0;
    int tries_ = 0;
    bool over_ = false, another_ = false;
    std::string reason_, last_answer_;
    std::optional<double> cruise_speed_mps_, airborne_s_, landed_s_, standing_s_, disarmed_s_;
    bool came_to_rest_ = false;  // since it touched down
    std::optional<double> touchdown_m_, touchdown_sink_mps_, loiter_radius_m_;
    double sink_mps_ = 0;  // when it was last off the ground
    std::array<double, 8> servo_us_{};
};

}  // namespace simulator
