// SPDX-License-Identifier: GPL-3.0-or-later
// What geodesy, the mission engine and the ground link take on the chip, in cycles without
// interrupts. Prints them all; fails when one that has a limit in BUDGETS is past it.
//   costs PROGRAMS_FOLDER BUDGETS.json mission|link|signing
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "programs/steps.hpp"
#include "simulator/machine/apm2_board.hpp"

using namespace simulator;

namespace {

using Task = BoardFigures::Task;
using Tasks = std::map<int, Task>;
enum class Figure { each, longest, all };

struct Line {
    const char* what;
    costs::Step step;
    Figure figure;
    const char* budget;  // nullptr: none
    int bytes = 1;       // of which one is counted
};

// clang-format off
const Line kMission[] = {
    {"idle poll",                                   costs::kIdlePoll,   Figure::longest, "mission_idle_poll_cycles"},
    {"step that sets a parameter and begins a NAV", costs::kHeavyStep,  Figure::longest, "mission_heavy_step_cycles"},
    {"advance over 145 actions, longest poll",      costs::kAdvance,    Figure::longest, "mission_advance_poll_cycles"},
    {"advance over 145 actions, all polls",         costs::kAdvance,    Figure::all,     "mission_advance_cycles"},
    {"upload of an item, longest",                  costs::kUploadItem, Figure::longest, "mission_upload_item_cycles"},
    {"upload of an item, mean",                     costs::kUploadItem, Figure::each,    nullptr},
};
const Line kLink[] = {
    {"HEARTBEAT received, MAVLink 1, a byte",         costs::kHeartbeat,     Figure::each, "link_received_byte_cycles", costs::kHeartbeatBytes},
    {"COMMAND_LONG received, MAVLink 2, a byte",      costs::kCommand,       Figure::each, "link_received_byte_cycles", costs::kCommandBytes},
    {"MISSION_ITEM_INT received, MAVLink 2, a byte",  costs::kItem,          Figure::each, "link_received_byte_cycles", costs::kItemBytes},
    {"noise, a byte, mean of 5000",                   costs::kNoise,         Figure::each, "link_noise_byte_cycles"},
    {"noise, a byte, longest",                        costs::kNoise,         Figure::longest, nullptr},
    {"false starts, a byte, mean of 1000",            costs::kFalseStarts,   Figure::each, "link_false_start_byte_cycles"},
    {"false starts, a byte, longest",                 costs::kFalseStarts,   Figure::longest, nullptr},
    {"HEARTBEAT sent, MAVLink 1, 17 bytes",           costs::kSendHeartbeat, Figure::each, "link_sent_heartbeat_cycles"},
    {"GLOBAL_POSITION_INT sent, MAVLink 2, 40 bytes", costs::kSendPosition,  Figure::each, "link_sent_position_cycles"},
    {"STATUSTEXT sent, MAVLink 2, 63 bytes",          costs::kSendText,      Figure::each, "link_sent_text_cycles"},
};
const Line kSigning[] = {
    {"a block of SHA-256",            costs::kHashBlock,   Figure::each,    "sha256_block_cycles"},
    {"a quarter of a block, longest", costs::kHashQuarter, Figure::longest, "sha256_quarter_cycles"},
    {"a signed COMMAND_LONG checked", costs::kCheckSlice,  Figure::all,     "signing_frame_cycles"},
    {"a slice of that, longest",      costs::kCheckSlice,  Figure::longest, "signing_slice_cycles"},
    {"a GLOBAL_POSITION_INT signed",  costs::kSignSlice,   Figure::all,     "signing_frame_cycles"},
    {"a slice of that, longest",      costs::kSignSlice,   Figure::longest, "signing_slice_cycles"},
};
struct Pair {
    const char* what;
    costs::Step ours, naive;
};
const Pair kGeodesy[] = {
    {"distance",       costs::kDistance, costs::kNaiveDistance},
    {"bearing",        costs::kBearing,  costs::kNaiveBearing},
    {"offset",         costs::kOffset,   costs::kNaiveOffset},
    {"along, across",  costs::kTrack,    costs::kNaiveTrack},
    {"line crossed",   costs::kPassed,   costs::kNaivePassed},
};
// clang-format on

// Runs until the program has done its last step.
Tasks run(const std::string& program, costs::Step last, double at_most_s) {
    WorldOptions options;
    options.bootloader = Bootloader::quick;
    AvrBoard board(program, options);
    Tasks tasks;
    for (uint64_t time_us = 0; time_us < at_most_s * 1e6; time_us += 100'000) {
        if (!board.runUntil(time_us)) break;
        tasks.clear();
        for (const Task& task : board.figures().tasks) tasks[task.number] = task;
        if (tasks.count(costs::kBroken - 1) != 0) break;
        if (tasks.count(last - 1) != 0) return tasks;
    }
    std::printf("%s does not come to its end %s\n", program.c_str(), board.fault().c_str());
    for (const auto& task : tasks) std::printf("%d: %u\n", task.first, task.second.runs);
    std::exit(1);
}

class Costs {
public:
    Costs(Tasks tasks, nlohmann::json budgets)
        : tasks_(std::move(tasks)), budgets_(std::move(budgets)) {}

    double cycles(costs::Step step, Figure figure) const {
        const auto found = tasks_.find(step - 1);
        if (found == tasks_.end()) return -1;
        const Task& task = found->second;
        const double marks = tasks_.at(costs::kNothing - 1).mean_cycles;
        if (figure == Figure::longest) return task.max_cycles - marks;
        return (task.mean_cycles - marks) * (figure == Figure::all ? task.runs : 1);
    }

    bool holds(const Line& line) const {
        const double cycles = this->cycles(line.step, line.figure) / line.bytes;
        std::printf("%-46s %9.0f cycles %8.1f us", line.what, cycles, cycles / 16);
        if (line.figure == Figure::all) std::printf(" in %u polls", runs(line.step));
        bool within = cycles > 0;
        if (line.budget != nullptr) {
            const double most = budgets_.at(line.budget);
            within = within && cycles <= most;
            std::printf(", at most %.0f%s", most, within ? "" : "  FAILED");
        }
        std::printf("\n");
        return within;
    }

private:
    unsigned runs(costs::Step step) const { return tasks_.at(step - 1).runs; }

    Tasks tasks_;
    nlohmann::json budgets_;
};

bool geodesy(const Costs& costs) {
    bool ran = true;
    std::printf("%-16s %10s %10s   cycles; the naive one holds degrees in floats\n", "", "ours",
                "naive");
    for (const Pair& pair : kGeodesy) {
        const double ours = costs.cycles(pair.ours, Figure::each);
        const double naive = costs.cycles(pair.naive, Figure::each);
        std::printf("%-16s %10.0f %10.0f\n", pair.what, ours, naive);
        ran = ran && ours > 0 && naive > 0 && ours < naive;
    }
    std::printf("%-16s %10.0f\n", "in a new band", costs.cycles(costs::kNewBand, Figure::each));
    return ran;
}

}  // namespace

int main(int count, char** words) {
    const std::string what = count == 4 ? words[3] : "";
    if (what != "mission" && what != "link" && what != "signing") {
        std::fprintf(stderr, "usage: costs PROGRAMS_FOLDER BUDGETS.json mission|link|signing\n");
        return 2;
    }
    const std::string program = std::string(words[1]) + "/cost_";
    std::ifstream file(words[2]);
    const nlohmann::json budgets = nlohmann::json::parse(file);
    bool within = true;
    const auto hold = [&](const auto& lines, const Costs& costs) {
        for (const Line& line : lines) within = costs.holds(line) && within;
    };
    if (what == "link") {
        hold(kLink, Costs(run(program + "link.elf", costs::kNothing, 10), budgets));
    } else if (what == "signing") {
        hold(kSigning, Costs(run(program + "signing.elf", costs::kNothing, 10), budgets));
    } else {
        within = geodesy(Costs(run(program + "geodesy.elf", costs::kNaivePassed, 1), budgets));
        hold(kMission, Costs(run(program + "mission.elf", costs::kNothing, 120), budgets));
    }
    return within ? 0 : 1;
}
