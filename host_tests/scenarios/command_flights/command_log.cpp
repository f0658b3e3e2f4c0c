// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_log.hpp"

#include <sstream>

#include "hal/trace.hpp"
#include "mission/sequencer.hpp"

namespace {

std::string wordOf(mission::Event event, int item) {
    const std::string i = std::to_string(item);
    switch (event) {
        case mission::Event::started:
        case mission::Event::resumed:
            return "W" + i;
        case mission::Event::reached:
            return "+" + i;
        case mission::Event::waits:
            return "c" + i;
        case mission::Event::waited:
            return "-" + i;
        case mission::Event::runs:
            return "a" + i;
        case mission::Event::skipped:
            return "?" + i;
        case mission::Event::looped:
            return "loop" + i;
        case mission::Event::hold:
            return "hold";
        case mission::Event::complete:
            return "RTL";
        case mission::Event::landed:
            return "landed";
        case mission::Event::reset:
            return "reset";
        case mission::Event::lost:
            return "lost" + i;
    }
    return "event " + std::to_string(static_cast<int>(event));
}

// Without the parameters, and without where a leg begins.
std::string plain(const std::string& said) {
    std::istringstream in(said);
    std::string word, all;
    while (in >> word) all += word.substr(0, word.find_first_of("(!~@")) + " ";
    return all;
}

}  // namespace

void CommandLog::mark(uint8_t value, uint8_t item, double time_s) {
    if (value < hal::kTraceMission || value > hal::kTraceMission + 0x0F) return;
    const auto event = static_cast<mission::Event>(value - hal::kTraceMission);
    // an upload resets too; the flight's own is the last
    if (event == mission::Event::reset && entries_.size() == 1) entries_.clear();
    // a NAV that comes back is reported twice: that AUTO is entered again is the first of it
    if (event == mission::Event::resumed) entries_.push_back({time_s, "again"});
    entries_.push_back({time_s, wordOf(event, item)});
}

std::optional<double> CommandLog::time_s(const std::string& word) const {
    for (const Entry& entry : entries_)
        if (entry.word == word) return entry.time_s;
    return std::nullopt;
}

std::string CommandLog::navsFinished() const {
    std::string all;
    for (const Entry& entry : entries_)
        if (entry.word[0] == '+') all += entry.word + " ";
    return all;
}

std::string CommandLog::words() const {
    std::string all;
    for (const Entry& entry : entries_)
        if (entry.word[0] != '-' && entry.word != "again") all += entry.word + " ";
    return all;
}

std::string CommandLog::oracles(oracle::CommandSet set, const oracle::Mission& mission) const {
    oracle::Interpreter oracle(set, mission);
    std::string all;
    for (const Entry& entry : entries_) {
        const bool enters = entry.word == "reset" || entry.word == "again";
        if (enters) oracle.enterAuto(false);
        if (!enters && entry.word[0] != '+' && entry.word[0] != '-') continue;
        oracle.pass(entry.word[0] == '+', entry.word[0] == '-');
        all += plain(oracle.trace());
    }
    return all;
}
