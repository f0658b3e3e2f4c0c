// SPDX-License-Identifier: GPL-3.0-or-later
// What came before a frame: what the board has sent on its links, what ground stations have sent,
// and when the pilot, the world or the processor last gave a cause for something.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "simulator/invariants/plan_on_the_wire.hpp"
#include "simulator/invariants/snapshot.hpp"

namespace simulator::invariants {

struct Heard {  // a heartbeat
    double time_s = kNever_s;
    bool armed = false;
    uint32_t mode = 0;
};

// What a ground station, the pilot or the world did that explains what follows.
enum class Cause {
    arms,         // any command to arm or disarm
    forces,       // one that is to be obeyed whatever is wrong
    flight_mode,  // a command that may change the mode, or GUIDED's target
    mission,      // the mission or its current item
    go_around,    // ordered by command
    servo,        // an output set by command
    overrides,    // the ground station's sticks
    parameter,
    reboot,
    mode_switch,    // one of the channels 5 to 8 moved, or that of FLTMODE_CH or RST_SWITCH_CH
    stick,          // one of roll, pitch and yaw at its end
    rudder,         // yaw at its end
    throttle,       // the pilot's, open
    radio_back,     // heard again, and so the mode switch
    channel_count,  // its frames have another number of channels than when it was heard last
    restart,
    fault,  // a sensor failed, fails, or has failed a moment ago
    count
};

class History {
public:
    History() { faulted_s_.fill(kNever_s); }
    void frame(const Snapshot& now);
    void received(const mavlink::Frame& frame, double now_s);
    void sent(const mavlink::Frame& frame, double now_s);

    bool within(Cause cause, double from_s, double to_s) const;
    double last_s(Cause cause) const;
    double faulted_s(Faulty sensor) const { return faulted_s_[static_cast<size_t>(sensor)]; }
    // A text that begins so, in this time.
    bool saidWithin(const char* begins, double from_s, double to_s) const;

    const Heard& heard() const { return heard_; }
    const Heard& heardBefore() const { return heard_before_; }
    uint64_t heartbeats() const { return heartbeats_; }
    bool reachedWithin(int item, double from_s, double to_s) const;
    int item() const { return item_; }  // MISSION_CURRENT; -1: not heard of yet
    int itemBefore() const { return item_before_; }
    uint64_t itemChanges() const { return item_changes_; }
    const std::optional<mavlink::GlobalPositionInt>& position() const { return position_; }
    double position_s() const { return position_s_; }
    const std::optional<mavlink::VfrHud>& hud() const { return hud_; }
    double hud_s() const { return hud_s_; }
    const std::optional<Plan>& plan() const { return plan_.plan(); }
    // The value the board has given it last; `otherwise` when it never did.
    double parameter(const std::string& name, double otherwise) const;
    const std::map<std::string, float>& parametersSet() const { return set_; }

private:
    struct Span {
        double from_s, to_s;
    };
    void mark(Cause cause, double now_s);
    size_t channelOf(const char* parameter) const;
    bool throttleSaysLost(const Snapshot& now) const;
    void command(uint16_t number, float param1, float param2, double now_s);
    void heartbeat(const mavlink::Heartbeat& message, double now_s);
    void text(const mavlink::Statustext& message, double now_s);
    void current(int item);

    std::array<std::vector<Span>, static_cast<size_t>(Cause::count)> causes_;  // the newest
    std::array<double, kFaulty> faulted_s_;
    Snapshot before_;
    bool nine_heard_ = false;  // channels, when the receiver was heard last
    Heard heard_, heard_before_;
    uint64_t heartbeats_ = 0, item_changes_ = 0;
    int item_ = -1, item_before_ = -1;
    std::optional<mavlink::GlobalPositionInt> position_;
    std::optional<mavlink::VfrHud> hud_;
    double position_s_ = kNever_s, hud_s_ = kNever_s, override_s_ = kNever_s;
    struct Said {
        double time_s;
        std::string text;
    };
    std::vector<Said> said_;
    std::map<int, double> reached_s_;
    PlanOnTheWire plan_;
    std::map<std::string, float> values_;  // as reported
    std::map<std::string, float> set_;     // and asked for before: the acknowledged writes
    struct Asked {
        double time_s;
        float value;
    };
    std::map<std::string, Asked> asked_;
};

}  // namespace simulator::invariants
