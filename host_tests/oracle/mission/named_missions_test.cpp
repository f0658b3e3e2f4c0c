// SPDX-License-Identifier: GPL-3.0-or-later
// The rules of docs/mission.md and the traps other autopilots' users fell into: engine and oracle
// agree on each, and on what its row says.
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "mission_rules.hpp"
#include "trial.hpp"

namespace {

using namespace oracle;

// The words are those of mission_rules.hpp.
Bytes item(CommandSet set, const std::string& word, int index) {
    const bool apm1 = set == CommandSet::apm1;
    if (word == "WP") return make(set, 0x10, 0, index, 1, 1);
    if (word == "HERE") return make(set, 0x10, 0, index, 0, 0);
    if (word == "ODD") return make(set, 0x10, kOutOfRange, index, 1, 1);
    if (word == "LAND") return make(set, 0x15, 0, index, 1, 1);
    if (word == "TAKEOFF") return make(set, 0x16, 0, index, 0, 0);
    if (word == "COND") return make(set, apm1 ? 0x20 : 0x70, 0, index, 0, 0);
    if (word == "DO") return make(set, apm1 ? 0x81 : 0xB5, 0, index, 0, 0);
    if (word == "QUIT") return make(set, apm1 ? 0x30 : 0xB5, kLeavesAuto, index, 0, 0);
    if (word == "WHAT") return make(set, 0xEE, 0, index, 0, 0);
    if (word == "J") return make(set, 0x31, 0, 0, 0, 0);
    const size_t times = word.find('x');
    const int target = std::stoi(word.substr(1));
    if (apm1) return make(set, 0x75, 0, target, 0, 0);
    return make(set, 0xB1, target, 0,
                times == std::string::npos ? -1 : std::stoi(word.substr(times + 1)), 0);
}

Stored store(CommandSet set, const std::string& words) {
    Stored stored{set, {make(set, 0x10, 0, 0, 7, 7)}};
    std::istringstream in(words);
    std::string word;
    while (in >> word)
        stored.mission.push_back(item(set, word, static_cast<int>(stored.mission.size())));
    return stored;
}

Step step(const std::string& word) {
    Step step;
    if (word == "nav" || word == "both") step.how.nav = true;
    if (word == "cond" || word == "both") step.how.condition = true;
    if (word == "auto") step.what = Happens::enter;
    if (word == "afresh") step.what = Happens::enter_afresh;
    if (word == "leave") step.what = Happens::leave;
    if (word == "watchdog") step.what = Happens::watchdog;
    if (word == "power") step.what = Happens::power_loss;
    if (word == "trail") step = {Happens::trailing, 1, {}};
    if (word == "commit") step = {Happens::commit, 1, {}};
    if (word.compare(0, 3, "set") == 0)
        step = {Happens::set_current, std::stoi(word.substr(3)), {}};
    return step;
}

// What the engine says, without parameters and resets; or where it and the oracle part.
std::string flown(CommandSet set, const std::string& mission, const std::string& happens,
                  const std::string& then = "") {
    Trial trial;
    trial.missions = {store(set, mission), store(set, then)};
    std::istringstream in(happens);
    std::string word, said, plain;
    while (in >> word) trial.steps.push_back(step(word));
    const std::string parted = fly(trial, &said);
    if (!parted.empty()) return parted;
    std::istringstream words(said);
    while (words >> word)
        if (word != "reset") plain += (plain.empty() ? "" : " ") + word.substr(0, word.find('('));
    return plain;
}
// The trace in the oracle's words: whose place is taken, and after which NAV it holds, is not in
// it.
std::string inOraclesWords(const std::string& trace) {
    std::string words = std::regex_replace(trace, std::regex(" ?/"), "");
    words = std::regex_replace(words, std::regex("^ |@500"), "");
    return std::regex_replace(words, std::regex("hold[0-9]+"), "hold");
}

TEST(NamedMission, oracle_and_engine_fly_every_row_of_the_rules) {
    for (const MissionRule& rule : kMissionRules)
        EXPECT_EQ(flown(rule.set == 1 ? CommandSet::apm1 : CommandSet::apm2, rule.mission,
                        rule.steps, rule.then == nullptr ? "" : rule.then),
                  inOraclesWords(rule.trace))
            << rule.mission << ", " << rule.steps;
}

TEST(NamedMission, auto_is_refused_without_a_nav) {
    EXPECT_EQ(flown(CommandSet::apm2, "DO COND", "trail auto pass"), "");
}

}  // namespace
