// SPDX-License-Identifier: GPL-3.0-or-later
// The order of execution once more: plain, slow, with its own reading of the 14 bytes, and not a
// line in common with the engine it is held against. What it says is a line of words:
//   W5 flies NAV 5 (leg from the last place; W5! from the airplane; W5~ goes on after a break;
//   @7 at the place where the airplane was at step 7)    +5 finished    c5 CONDITION 5 starts
//   a5 action 5 runs    ?5 passed over, unusable    loop5 too many steps, jump 5 passed over
//   hold circles the last place    RTL, landed the mission is over    reset begins afresh
// The parameters follow what uses them: a5(p1,p2,p3,p4).
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace oracle {

using Bytes = std::array<uint8_t, 14>;
using Mission = std::vector<Bytes>;  // item 0 is home
enum class CommandSet { apm1, apm2 };
enum class Kind { nothing, nav, condition, action, jump };

struct Command {
    int id = 0, options = 0, p1 = 0;
    int64_t p2 = 0, p3 = 0, p4 = 0;
    Kind kind = Kind::nothing;  // unknown or out of range
    bool isNav() const { return kind == Kind::nav; }
};

constexpr int kOutOfRange = 99;  // a p1 that the commands of these tests refuse
constexpr int kLeavesAuto = 77;  // a p1 by which an action of these tests changes the mode

Command decode(CommandSet set, const Mission& mission, int index);
bool holdsNav(CommandSet set, const Mission& mission);

class Interpreter {
public:
    Interpreter(CommandSet set, Mission mission) : set_(set), mission_(std::move(mission)) {}

    // What happens to the airplane.
    void enterAuto(bool restart);
    void leaveAuto() { in_auto_ = false; }
    // records: how many are there before the pass has to wait for one; the next call goes on.
    void pass(bool nav_finished, bool condition_finished, int records = 1000000);
    bool setCurrent(int n);
    void commit(CommandSet set, Mission mission);
    void loseMemory(int index);  // power loss: the index of the NAV is left, if there was one
    void trailing(bool on) { mis_trailing_ = on; }
    void airplaneAt(int place) { airplane_ = place; }

    // What can be seen.
    std::string trace();
    bool mayEnterAuto() const { return holdsNav(set_, mission_); }
    bool inAuto() const { return in_auto_; }
    bool over() const { return phase_ == Phase::over; }
    int nav() const { return phase_ == Phase::flying ? nav_ : 0; }
    bool navFlies() const { return phase_ == Phase::flying && nav_started_; }
    int conditionRunning() const { return condition_; }
    const std::map<int, int>& jumpsLeft() const { return jumps_left_; }

private:
    enum class Phase { seeking, flying, trailing, over };

    int count() const { return static_cast<int>(mission_.size()); }
    Command command(int index) const { return decode(set_, mission_, index); }
    void say(const std::string& word);

    void restart();
    void forget();
    void go(int target, bool with_chain);
    void load(int nav, int chain_begin);
    void finishNav();
    void startNav(bool resumed);
    void beginPass();
    void resume();
    void proceed();
    bool recordIsThere();
    bool seek();
    bool goRound();
    void noNavLeft();
    bool runChain();
    void startCondition(int at, const Command& condition);
    void runJump(int at, const Command& jump);
    bool mayJumpApm1(int at);
    bool mayJumpApm2(int at, const Command& jump);
    bool countLeft(int at, const Command& jump) const;
    void endOfChain();
    void complete();
    std::vector<Bytes> chainOf(const Mission& mission, int from) const;
    bool sameInFlight(CommandSet set, const Mission& mission) const;

    CommandSet set_;
    Mission mission_;
    bool mis_trailing_ = false;
    int airplane_ = 0;
    std::string trace_;

    bool in_auto_ = false;
    bool comes_back_ = false;  // AUTO has been entered again
    bool fresh_ = true;        // nobody said where AUTO begins
    bool chosen_ = false;      // the ground did
    bool mid_pass_ = false;    // a record is waited for
    int records_left_ = 0;
    Phase phase_ = Phase::seeking;
    int target_ = 1, cursor_ = 1;  // where a NAV is sought from, and how far
    bool with_chain_ = true;
    int loop_ = 0;  // 2.0: the jump that leads on behind the last NAV; its place in the chain ...
    bool loop_ahead_ = false;  // ... has not been come to
    int nav_ = 0;              // loaded
    Command nav_command_;      // with the place it took
    bool nav_started_ = false;
    bool from_here_ = true;
    bool on_ground_ = false;           // a LAND was the last to finish
    int chain_begin_ = 0, chain_ = 0;  // where the chain began, where it stands
    bool chain_dropped_ = false;
    std::set<int> run_begins_;  // 1.0: where the chain went on after its jumps
    int condition_ = 0;         // running
    std::map<int, int> jumps_left_;
    std::set<int> jumped_, blocked_;  // 1.0: in this pass; until the next NAV loads
    int steps_ = 0;
    bool loop_reported_ = false;
};

}  // namespace oracle
