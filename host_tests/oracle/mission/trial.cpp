// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial.hpp"

#include <algorithm>
#include <cstdio>

namespace oracle {
namespace {

const char* const kWords[] = {"pass",   "enter AUTO",  "enter AUTO afresh",
                              "leave",  "set current", "MIS_TRAILING",
                              "commit", "watchdog",    "power loss"};

void put(Bytes& bytes, int at, int length, int64_t value) {
    for (int i = 0; i < length; ++i)
        bytes[static_cast<size_t>(at + i)] = static_cast<uint8_t>(value >> (8 * i));
}

// Both go through one step.
void happen(const Trial& trial, const Step& step, Interpreter& oracle, Rig& engine) {
    switch (step.what) {
        case Happens::pass: {
            const Rig::Passed passed = engine.pass(step.how);
            oracle.pass(step.how.nav, step.how.condition, passed.records);
            if (passed.late_nav || passed.late_condition)
                oracle.pass(passed.late_nav, passed.late_condition);
            break;
        }
        case Happens::enter:
        case Happens::enter_afresh:
            if (oracle.inAuto() || !oracle.mayEnterAuto()) break;
            oracle.enterAuto(step.what == Happens::enter_afresh);
            engine.enterAuto(step.what == Happens::enter_afresh);
            oracle.pass(false, false);
            engine.pass({});
            break;
        case Happens::leave:
            oracle.leaveAuto();
            engine.leaveAuto();
            break;
        case Happens::set_current:
            if (!oracle.mayEnterAuto()) break;  // nor may it choose where to begin
            oracle.setCurrent(step.argument);
            engine.setCurrent(step.argument);
            break;
        case Happens::trailing:
            oracle.trailing(step.argument != 0);
            engine.trailing(step.argument != 0);
            break;
        case Happens::commit: {
            const Stored& stored = trial.missions[static_cast<size_t>(step.argument)];
            oracle.commit(stored.set, stored.mission);
            engine.commit(stored.set, stored.mission);
            break;
        }
        case Happens::watchdog:
            oracle.leaveAuto();
            engine.watchdog();
            break;
        case Happens::power_loss:
            engine.loseMemory(oracle.nav());
            oracle.loseMemory(oracle.nav());
            break;
    }
}

template <typename Counters>
std::string words(const Counters& counters) {
    std::string all;
    for (const auto& counter : counters)
        all += " J" + std::to_string(counter.first) + ":" + std::to_string(counter.second);
    return all;
}

std::string difference(Interpreter& oracle, Rig& engine, std::string* said) {
    const std::string should = oracle.trace(), does = engine.trace();
    if (said != nullptr && !does.empty()) *said += (said->empty() ? "" : " ") + does;
    if (!engine.broken().empty()) return engine.broken();
    if (should != does) return "oracle: " + should + "\nengine: " + does;
    const auto differs = [](const char* what, int oracles, int engines) {
        return std::string(what) + ": oracle " + std::to_string(oracles) + ", engine " +
               std::to_string(engines);
    };
    if (oracle.inAuto() != engine.inAuto())
        return differs("in AUTO", oracle.inAuto(), engine.inAuto());
    if (oracle.over() != engine.over()) return differs("over", oracle.over(), engine.over());
    if (oracle.navFlies() && oracle.nav() != engine.current())
        return differs("current", oracle.nav(), engine.current());
    if ((oracle.conditionRunning() != 0) != engine.conditionRuns())
        return differs("condition", oracle.conditionRunning(), engine.conditionRuns());
    if (words(oracle.jumpsLeft()) != words(engine.jumpsLeft()))
        return "jumps left: oracle" + words(oracle.jumpsLeft()) + ", engine" +
               words(engine.jumpsLeft());
    return "";
}

std::string readable(const Stored& stored) {
    std::string all = stored.set == CommandSet::apm1 ? "APM 1.0" : "APM 2.0";
    for (size_t i = 1; i < stored.mission.size(); ++i) {
        const Command c = decode(stored.set, stored.mission, static_cast<int>(i));
        const char* const kinds[] = {"-", "NAV", "CONDITION", "DO", "JUMP"};
        char line[160];
        snprintf(line, sizeof line, "\n  %3d  0x%02X %-9s p1 %d p2 %ld p3 %ld p4 %ld", int(i), c.id,
                 kinds[static_cast<int>(c.kind)], c.p1, long(c.p2), long(c.p3), long(c.p4));
        all += line;
    }
    return all + "\n";
}

std::string readable(const Step& step) {
    std::string words = kWords[static_cast<int>(step.what)];
    if (step.what == Happens::set_current || step.what == Happens::trailing ||
        step.what == Happens::commit)
        words += " " + std::to_string(step.argument);
    if (step.how.nav) words += ", NAV finished";
    if (step.how.condition) words += ", CONDITION finished";
    if (step.how.busy != 0) words += ", records late " + std::to_string(step.how.busy);
    if (step.how.cut != 0) words += ", left at late record " + std::to_string(step.how.cut);
    if (step.how.late_nav) words += ", NAV finished meanwhile";
    if (step.how.late_condition) words += ", CONDITION finished meanwhile";
    return words;
}

bool parts(const Trial& trial) { return !fly(trial).empty(); }

bool withoutSteps(Trial& trial) {
    bool smaller = false;
    for (size_t length = trial.steps.size(); length > 0; length /= 2)
        for (size_t at = 0; at + length <= trial.steps.size();) {
            Trial less = trial;
            const auto from = less.steps.begin() + static_cast<long>(at);
            less.steps.erase(from, from + static_cast<long>(length));
            if (parts(less)) {
                trial = less;
                smaller = true;
            } else {
                ++at;
            }
        }
    return smaller;
}

bool withPlainSteps(Trial& trial) {
    bool smaller = false;
    for (size_t at = 0; at < trial.steps.size(); ++at)
        for (auto part : {&Pass::nav, &Pass::condition, &Pass::late_nav, &Pass::late_condition}) {
            Trial less = trial;
            if (!(less.steps[at].how.*part)) continue;
            less.steps[at].how.*part = false;
            if (!parts(less)) continue;
            trial = less;
            smaller = true;
        }
    for (size_t at = 0; at < trial.steps.size(); ++at) {
        Trial less = trial;
        if (less.steps[at].how.busy == 0) continue;
        less.steps[at].how.busy = 0;
        less.steps[at].how.cut = 0;
        if (!parts(less)) continue;
        trial = less;
        smaller = true;
    }
    return smaller;
}

// Takes an item out; whatever pointed behind it follows.
Mission without(const Stored& stored, size_t item) {
    Mission mission = stored.mission;
    mission.erase(mission.begin() + static_cast<long>(item));
    for (size_t i = 1; i < mission.size(); ++i) {
        const bool jump2 = stored.set == CommandSet::apm2 && mission[i][0] == 0xB1;
        const bool jump1 = stored.set == CommandSet::apm1 && mission[i][0] == 0x75;
        if (jump2 && mission[i][2] > item) --mission[i][2];
        if (jump1 && mission[i][2] > item && mission[i][3] == 0) --mission[i][2];
        if (jump1 && mission[i][2] == 0 && mission[i][1] > item) --mission[i][1];
        const size_t p2 = stored.set == CommandSet::apm1 ? 2 : 3;
        if (!jump2 && !jump1) mission[i][p2] = static_cast<uint8_t>(i);
    }
    return mission;
}

bool withoutItemInAll(Trial& trial) {
    bool smaller = false;
    size_t longest = 0;
    for (const Stored& stored : trial.missions) longest = std::max(longest, stored.mission.size());
    for (size_t item = longest; item-- > 1;) {
        Trial less = trial;
        for (Stored& stored : less.missions)
            if (item < stored.mission.size()) stored.mission = without(stored, item);
        if (!parts(less)) continue;
        trial = less;
        smaller = true;
    }
    return smaller;
}

bool withoutItems(Trial& trial) {
    bool smaller = withoutItemInAll(trial);
    for (size_t m = 0; m < trial.missions.size(); ++m)
        for (size_t item = trial.missions[m].mission.size(); item-- > 1;) {
            Trial less = trial;
            less.missions[m].mission = without(trial.missions[m], item);
            if (!parts(less)) {
                for (Step& step : less.steps)
                    if (step.what == Happens::set_current && step.argument > int(item))
                        --step.argument;
                if (!parts(less)) continue;
            }
            trial = less;
            smaller = true;
        }
    return smaller;
}

}  // namespace

Bytes make(CommandSet set, int id, int p1, int64_t p2, int64_t p3, int64_t p4) {
    Bytes bytes{};
    bytes[0] = static_cast<uint8_t>(id);
    const bool apm1 = set == CommandSet::apm1;
    bytes[apm1 ? 1 : 2] = static_cast<uint8_t>(p1);
    put(bytes, apm1 ? 2 : 3, apm1 ? 4 : 3, p2);
    put(bytes, 6, 4, p3);
    put(bytes, 10, 4, p4);
    return bytes;
}

std::string fly(const Trial& trial, std::string* said, long* passes, int* most) {
    const Stored& first = trial.missions.front();
    Interpreter oracle(first.set, first.mission);
    Rig engine(first.set, first.mission);
    int number = 0;
    for (const Step& step : trial.steps) {
        ++number;
        oracle.airplaneAt(number);
        engine.airplaneAt(number);
        const bool in_auto = oracle.inAuto();
        happen(trial, step, oracle, engine);
        if (passes != nullptr && step.what == Happens::pass && in_auto) ++*passes;
        if (most != nullptr) *most = std::max(*most, engine.reads());
        const std::string different = difference(oracle, engine, said);
        if (!different.empty())
            return "step " + std::to_string(number) + " (" + readable(step) + ")\n" + different;
    }
    return "";
}

Trial minimise(Trial trial) {
    for (bool smaller = true; smaller;) {
        smaller = withoutSteps(trial);
        smaller = withPlainSteps(trial) || smaller;
        smaller = withoutItems(trial) || smaller;
    }
    return trial;
}

std::string readable(const Trial& trial) {
    std::string all;
    std::set<int> used = {0};
    for (const Step& step : trial.steps)
        if (step.what == Happens::commit) used.insert(step.argument);
    for (int m : used)
        all += "mission " + std::to_string(m) + ": " +
               readable(trial.missions[static_cast<size_t>(m)]);
    int number = 0;
    for (const Step& step : trial.steps)
        all += "step " + std::to_string(++number) + ": " + readable(step) + "\n";
    return all;
}

}  // namespace oracle
