// SPDX-License-Identifier: GPL-3.0-or-later
// What receiving and sending on the ground link take on the chip, in cycles without interrupts.
// Prints them; fails when one is past its limit in BUDGETS.
//   mavlink_costs PROGRAM.elf BUDGETS.json
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "programs/link_steps.hpp"
#include "simulator/machine/apm2_board.hpp"

using namespace simulator;

namespace {

using Tasks = std::map<int, BoardFigures::Task>;

struct Line {
    const char* what;
    costs::Step step;
    int bytes;
    const char* budget;
};

// clang-format off
const Line kLines[] = {
    {"HEARTBEAT received, MAVLink 1, a byte",           costs::kHeartbeat,     costs::kHeartbeatBytes, "link_received_byte_cycles"},
    {"COMMAND_LONG received, MAVLink 2, a byte",        costs::kCommand,       costs::kCommandBytes,   "link_received_byte_cycles"},
    {"MISSION_ITEM_INT received, MAVLink 2, a byte",    costs::kItem,          costs::kItemBytes,      "link_received_byte_cycles"},
    {"noise, a byte, mean of 5000",                     costs::kNoise,         1,                      "link_noise_byte_cycles"},
    {"false starts, a byte, mean of 1000",              costs::kFalseStarts,   1,                      "link_false_start_byte_cycles"},
    {"HEARTBEAT sent, MAVLink 1, 17 bytes",             costs::kSendHeartbeat, 1,                      "link_sent_heartbeat_cycles"},
    {"GLOBAL_POSITION_INT sent, MAVLink 2, 40 bytes",   costs::kSendPosition,  1,                      "link_sent_position_cycles"},
    {"STATUSTEXT sent, MAVLink 2, 63 bytes",            costs::kSendText,      1,                      "link_sent_text_cycles"},
};
// clang-format on

Tasks run(const std::string& program) {
    AvrBoard board(program, WorldOptions());
    for (uint64_t time_us = 0; time_us < 10'000'000; time_us += 100'000) {
        if (!board.runUntil(time_us)) break;
        Tasks tasks;
        for (const auto& task : board.figures().tasks) tasks[task.number + 1] = task;
        if (tasks.count(0x7F) != 0) break;
        if (tasks.count(costs::kNothing) != 0) return tasks;
    }
    std::fprintf(stderr, "the program does not come to its end %s\n", board.fault().c_str());
    std::exit(1);
}

}  // namespace

int main(int count, char** words) {
    if (count != 3) {
        std::fprintf(stderr, "usage: mavlink_costs PROGRAM.elf BUDGETS.json\n");
        return 2;
    }
    std::ifstream file(words[2]);
    const nlohmann::json budgets = nlohmann::json::parse(file);
    Tasks tasks = run(words[1]);
    const double marks = tasks.at(costs::kNothing).mean_cycles;
    bool all_kept = true;
    for (const Line& line : kLines) {
        const double cycles = (tasks.at(line.step).mean_cycles - marks) / line.bytes;
        const double most = budgets.at(line.budget);
        const bool kept = cycles > 0 && cycles <= most;
        std::printf("%-46s %7.0f cycles, at most %.0f%s\n", line.what, cycles, most,
                    kept ? "" : "  FAILED");
        all_kept = all_kept && kept;
    }
    std::printf("longest of one byte: noise %.0f, false starts %.0f cycles\n",
                tasks.at(costs::kNoise).max_cycles - marks,
                tasks.at(costs::kFalseStarts).max_cycles - marks);
    return all_kept ? 0 : 1;
}
