// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle.hpp"

#include <algorithm>

namespace oracle {
namespace {

constexpr int kLand = 0x15, kTakeoff = 0x16, kContinue = 0x1E, kToHeight = 0x1F;
constexpr int kDoJump = 0xB1, kToFirst = 0x31, kToIndex = 0x75;
constexpr int kForEver = -1;

int64_t littleEndian(const Bytes& bytes, int at, int length) {
    int64_t value = 0;
    for (int i = 0; i < length; ++i) value += static_cast<int64_t>(bytes[at + i]) << (8 * i);
    const int64_t sign = int64_t{1} << (8 * length - 1);
    return value >= sign ? value - 2 * sign : value;
}

Kind kindApm1(int id) {
    if (id >= 0x10 && id <= 0x16) return Kind::nav;
    if (id == 0x20 || id == 0x21) return Kind::condition;
    if (id == kToFirst || id == kToIndex) return Kind::jump;
    const bool action = id == 0x30 || (id >= 0x32 && id <= 0x34) || (id >= 0x40 && id <= 0x42) ||
                        (id >= 0x60 && id <= 0x64) || (id >= 0x70 && id <= 0x73) ||
                        (id >= 0x80 && id <= 0x82);
    return action ? Kind::action : Kind::nothing;
}

Kind kindApm2(int id) {
    if ((id >= 0x10 && id <= 0x17) || id == kContinue || id == kToHeight) return Kind::nav;
    if (id >= 0x70 && id <= 0x73) return Kind::condition;
    if (id == kDoJump) return Kind::jump;
    static const std::set<int> beyond = {0x5D, 0xBD, 0xBF, 0xC3, 0xC5, 0xC9, 0xCB, 0xCD, 0xCE, 0xCF,
                                         0xD2, 0xD4, 0xF0, 0xF1, 0xF2, 0xD6, 0xF3, 0xF4, 0xF5};
    const bool action = (id > kDoJump && id <= 0xB8) || beyond.count(id) != 0;
    return action ? Kind::action : Kind::nothing;
}

int64_t targetOf(const Command& jump) {
    if (jump.id == kToFirst) return 1;
    if (jump.id == kToIndex) return jump.p2 != 0 ? jump.p2 : jump.p1;
    return jump.p1;
}

bool inRange(const Command& command, int index, int count) {
    if (command.kind != Kind::jump) return command.p1 != kOutOfRange;
    const int64_t target = targetOf(command);
    if (command.id == kToFirst) return true;
    if (target < 1 || target >= count) return false;
    if (command.id == kToIndex) return true;
    return target != index && (command.p3 == kForEver || (command.p3 >= 1 && command.p3 <= 32767));
}

// These have no place of their own that could mean "here".
bool hasPlace(int id) { return id != 0x14 && id != kTakeoff && id != kContinue; }
// The next leg begins at the airplane.
bool endsNowhere(int id) { return id == kTakeoff || id == kContinue; }

std::string parameters(const Command& command) {
    return "(" + std::to_string(command.p1) + "," + std::to_string(command.p2) + "," +
           std::to_string(command.p3) + "," + std::to_string(command.p4) + ")";
}

}  // namespace

Command decode(CommandSet set, const Mission& mission, int index) {
    const Bytes& bytes = mission[static_cast<size_t>(index)];
    Command command;
    command.id = bytes[0];
    if (set == CommandSet::apm1) {
        command.p1 = bytes[1];
        command.p2 = littleEndian(bytes, 2, 4);
        command.kind = kindApm1(command.id);
    } else {
        command.options = bytes[1];
        command.p1 = bytes[2];
        command.p2 = littleEndian(bytes, 3, 3);
        command.kind = kindApm2(command.id);
    }
    command.p3 = littleEndian(bytes, 6, 4);
    command.p4 = littleEndian(bytes, 10, 4);
    if (!inRange(command, index, static_cast<int>(mission.size()))) command.kind = Kind::nothing;
    return command;
}

bool holdsNav(CommandSet set, const Mission& mission) {
    for (size_t i = 1; i < mission.size(); ++i)
        if (decode(set, mission, static_cast<int>(i)).isNav()) return true;
    return false;
}

void Interpreter::say(const std::string& word) { trace_ += (trace_.empty() ? "" : " ") + word; }

std::string Interpreter::trace() {
    std::string said;
    said.swap(trace_);
    return said;
}

// ---- AUTO

void Interpreter::enterAuto(bool restart_wanted) {
    in_auto_ = true;
    if (phase_ == Phase::over || fresh_ || (restart_wanted && !chosen_)) {
        restart();
    } else {
        if (restart_wanted) {  // but where the ground said
            jumps_left_.clear();
            say("reset");
        }
        comes_back_ = true;
    }
}

void Interpreter::restart() {
    forget();
    fresh_ = !in_auto_;
    say("reset");
}

void Interpreter::forget() {
    fresh_ = true;
    comes_back_ = chosen_ = false;
    nav_ = 0;
    from_here_ = true;
    on_ground_ = false;
    jumps_left_.clear();
    blocked_.clear();
    go(1, true);
    mid_pass_ = false;
}

bool Interpreter::setCurrent(int n) {
    if (n < 0 || n >= count()) return false;
    if (n == 0) {
        restart();
        return true;
    }
    if (navFlies()) from_here_ = true;
    on_ground_ = false;
    go(n, true);
    fresh_ = comes_back_ = mid_pass_ = false;
    chosen_ = !in_auto_;
    return true;
}

void Interpreter::loseMemory(int index) {
    forget();
    in_auto_ = false;
    if (index == 0) return;
    go(index, false);
    fresh_ = false;
}

// The records of the chain that begins at `from`: to the next NAV, or to the end.
std::vector<Bytes> Interpreter::chainOf(const Mission& mission, int from) const {
    std::vector<Bytes> chain;
    for (int i = from; i < static_cast<int>(mission.size()); ++i) {
        if (decode(set_, mission, i).isNav()) break;
        chain.push_back(mission[static_cast<size_t>(i)]);
    }
    return chain;
}

bool Interpreter::sameInFlight(CommandSet set, const Mission& mission) const {
    if (!in_auto_ || set != set_) return false;
    const auto index = static_cast<size_t>(nav_);
    if (phase_ == Phase::trailing)
        return mission.size() == mission_.size() &&
               (nav_ == 0 || mission[index] == mission_[index]) &&
               chainOf(mission, chain_begin_) == chainOf(mission_, chain_begin_);
    if (phase_ != Phase::flying || index >= mission.size()) return false;
    if (mission[index] != mission_[index]) return false;
    if (loop_ != 0) {
        const auto part = [](const Mission& all, int from, int to) {
            const auto end = std::min(all.size(), static_cast<size_t>(to) + 1);
            return std::vector<Bytes>(all.begin() + from, all.begin() + static_cast<long>(end));
        };
        const int again = static_cast<int>(targetOf(command(loop_)));
        return mission.size() > static_cast<size_t>(chain_begin_) &&
               part(mission, chain_begin_, loop_) == part(mission_, chain_begin_, loop_) &&
               part(mission, again, nav_) == part(mission_, again, nav_);
    }
    for (const int begin : run_begins_)
        if (chainOf(mission, begin) != chainOf(mission_, begin)) return false;
    return chainOf(mission, chain_begin_) == chainOf(mission_, chain_begin_);
}

void Interpreter::commit(CommandSet set, Mission mission) {
    const bool same = holdsNav(set, mission) && sameInFlight(set, mission);
    set_ = set;
    mission_ = std::move(mission);
    if (same) {
        jumps_left_.clear();
        return;
    }
    const bool landed = on_ground_;
    restart();
    if (!in_auto_ || holdsNav(set_, mission_)) return;
    on_ground_ = landed;
    complete();
}

// ---- one pass

void Interpreter::pass(bool nav_finished, bool condition_finished, int records) {
    if (!in_auto_) return;
    chosen_ = false;
    if (phase_ == Phase::over) return;
    records_left_ = records;
    const bool goes_on = mid_pass_ && !comes_back_;
    if (!goes_on) beginPass();
    if (comes_back_) {
        resume();
        if (condition_ != 0) return;
    } else if (!goes_on && phase_ != Phase::seeking) {
        if (navFlies() && nav_finished) {
            finishNav();
        } else if (condition_ == 0 || !condition_finished) {
            return;
        }
        condition_ = 0;
    }
    mid_pass_ = true;
    proceed();
}

void Interpreter::beginPass() {
    steps_ = 0;
    loop_reported_ = false;
    jumped_.clear();
}

void Interpreter::resume() {
    comes_back_ = false;
    from_here_ = true;
    if (phase_ == Phase::trailing) say("hold");
    if (navFlies()) startNav(true);
    if (condition_ == 0) return;
    mid_pass_ = false;
    say("c" + std::to_string(condition_) + parameters(command(condition_)));
}

// Record after record, until the pass is over or a record is not there.
void Interpreter::proceed() {
    while (mid_pass_ && in_auto_) {
        const bool there = phase_ == Phase::seeking ? seek() : runChain();
        if (!there) return;
    }
}

bool Interpreter::recordIsThere() { return records_left_-- > 0; }

// As an APM 2.0 jump goes: to the first NAV at or after the target, and what stands between.
void Interpreter::go(int target, bool with_chain) {
    phase_ = Phase::seeking;
    condition_ = 0;
    nav_started_ = false;
    target_ = cursor_ = target;
    with_chain_ = with_chain;
    loop_ = 0;
    loop_ahead_ = false;
}

bool Interpreter::seek() {
    if (cursor_ >= count()) {
        if (!goRound()) noNavLeft();
        return true;
    }
    if (!recordIsThere()) return false;
    ++steps_;
    if (!command(cursor_).isNav())
        ++cursor_;
    else if (on_ground_ && command(cursor_).id != kTakeoff)
        complete();
    else
        load(cursor_, set_ == CommandSet::apm2 ? target_ : cursor_ + 1);
    return true;
}

// The first jump behind the last NAV that has count left: the NAV it leads to is flown, with what
// stands before it for a chain.
bool Interpreter::goRound() {
    if (set_ == CommandSet::apm1 || loop_ != 0) return false;
    for (int i = target_; i < count(); ++i) {
        const Command now = command(i);
        if (now.kind != Kind::jump || !countLeft(i, now)) continue;
        loop_ = i;
        cursor_ = static_cast<int>(targetOf(now));
        return true;
    }
    return false;
}

void Interpreter::noNavLeft() {
    const bool trails = set_ == CommandSet::apm2 && mis_trailing_ && target_ < count();
    if (!trails || on_ground_ || !mayEnterAuto()) return complete();
    phase_ = Phase::trailing;
    chain_begin_ = chain_ = target_;
    chain_dropped_ = false;
    say("hold");
}

void Interpreter::complete() {
    const bool landed = on_ground_;
    forget();
    phase_ = Phase::over;
    on_ground_ = landed;
    say(landed ? "landed" : "RTL");
    if (!landed) leaveAuto();
}

void Interpreter::load(int nav, int chain_begin) {
    loop_ahead_ = loop_ != 0;
    if (loop_ahead_) (void)mayJumpApm2(loop_, command(loop_));
    phase_ = Phase::flying;
    nav_ = nav;
    nav_command_ = command(nav);
    nav_started_ = false;
    if (hasPlace(nav_command_.id) && nav_command_.p3 == 0 && nav_command_.p4 == 0)
        nav_command_.p3 = airplane_;
    chain_begin_ = chain_ = chain_begin;
    run_begins_.clear();
    chain_dropped_ = !with_chain_;
    blocked_.clear();
    if (set_ == CommandSet::apm1) startNav(false);  // no jump of this set abandons it
}

void Interpreter::startNav(bool resumed) {
    nav_started_ = true;
    on_ground_ = false;
    const char* how = resumed ? "~" : from_here_ ? "!" : "";
    say("W" + std::to_string(nav_) + how + parameters(nav_command_));
}

void Interpreter::finishNav() {
    say("+" + std::to_string(nav_));
    condition_ = 0;
    from_here_ = endsNowhere(nav_command_.id);
    on_ground_ = nav_command_.id == kLand;
    // 1.0: the queue stands where the chain came to; what is left of the chain is dropped.
    go(set_ == CommandSet::apm1 ? chain_ : nav_ + 1, true);
}

// One command of the chain.
bool Interpreter::runChain() {
    const bool to_nav = phase_ == Phase::flying && set_ == CommandSet::apm2 && !loop_ahead_;
    const int end = to_nav ? nav_ : count();
    if (chain_dropped_ || chain_ >= end) {
        endOfChain();
        return true;
    }
    if (!recordIsThere()) return false;
    const int at = chain_;
    const Command now = command(at);
    if (now.kind == Kind::nav) {  // 1.0: waits for the one being flown
        endOfChain();
    } else if (loop_ahead_ && at == loop_) {
        loop_ahead_ = false;
        chain_ = static_cast<int>(targetOf(now));
    } else if (now.kind == Kind::jump) {
        runJump(at, now);
    } else if (now.kind == Kind::condition) {
        startCondition(at, now);
    } else {
        ++steps_;
        ++chain_;
        if (now.kind == Kind::nothing) say("?" + std::to_string(at));
        if (now.kind == Kind::action) say("a" + std::to_string(at) + parameters(now));
        if (now.kind == Kind::action && now.p1 == kLeavesAuto) leaveAuto();
    }
    return true;
}

void Interpreter::startCondition(int at, const Command& condition) {
    if (phase_ == Phase::flying && !nav_started_) startNav(false);
    condition_ = at;
    chain_ = at + 1;
    mid_pass_ = false;
    say("c" + std::to_string(at) + parameters(condition));
}

void Interpreter::endOfChain() {
    mid_pass_ = false;
    if (phase_ == Phase::trailing) return complete();
    if (!nav_started_) startNav(false);
}

void Interpreter::runJump(int at, const Command& jump) {
    chain_ = at + 1;
    if (steps_ >= 2 * count()) {
        if (!loop_reported_) say("loop" + std::to_string(at));
        loop_reported_ = true;
        return;
    }
    ++steps_;
    const int target = static_cast<int>(targetOf(jump));
    if (set_ == CommandSet::apm1) {
        if (!mayJumpApm1(at)) return;
        chain_ = target;
        run_begins_.insert(target);
    } else if (mayJumpApm2(at, jump)) {
        if (navFlies()) from_here_ = true;
        go(target, true);
    }
}

bool Interpreter::mayJumpApm1(int at) {
    if (blocked_.count(at) != 0) return false;
    if (jumped_.insert(at).second) return true;
    blocked_.insert(at);
    return false;
}

bool Interpreter::countLeft(int at, const Command& jump) const {
    const auto counter = jumps_left_.find(at);
    return jump.p3 == kForEver || counter == jumps_left_.end() || counter->second != 0;
}

bool Interpreter::mayJumpApm2(int at, const Command& jump) {
    if (jump.p3 == kForEver) return true;
    int& left = jumps_left_.emplace(at, static_cast<int>(jump.p3)).first->second;
    if (left == 0) return false;
    --left;
    return true;
}

}  // namespace oracle
