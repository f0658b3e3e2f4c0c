// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/machine/profile.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace simulator {

constexpr uint64_t kEntry = 5;  // cycles of an interrupt's entry

void Profile::add(const Step& step) {
    const uint64_t entry = step.interrupted ? std::min(kEntry, step.cycles) : 0;
    cycles_[step.address / 2] += step.cycles - entry;
    clock() += step.cycles - entry;
    // the last of a call's bytes on the stack have been taken
    while (!open_.empty() && step.stack > open_.back().stack) returnFrom();
    if (step.calls && !step.interrupted)
        open_.push_back({step.address, step.next, step.stack, clock(), false});
    if (!step.interrupted) return;
    ++in_interrupts_;
    open_.push_back({step.next, step.next, step.stack, clock(), true});
    cycles_[step.next / 2] += entry;
    clock() += entry;
}

void Profile::returnFrom() {
    const Open ended = open_.back();
    open_.pop_back();
    Call& call = calls_[{ended.from, ended.to}];
    ++call.runs;
    call.cycles += clock() - ended.since;
    if (ended.interrupt) --in_interrupts_;
}

std::string Profile::json(const Program& program, uint64_t all_cycles) const {
    const nlohmann::ordered_json from = {{"path", program.path}, {"sha256", program.sha256}};
    std::string text = "{\"program\":" + from.dump() + ",\n\"all\":" + std::to_string(all_cycles) +
                       ",\n\"cycles\":[";
    const char* between = "";
    for (size_t word = 0; word < cycles_.size(); word++) {
        if (cycles_[word] == 0) continue;
        text +=
            between + ("[" + std::to_string(word * 2)) + "," + std::to_string(cycles_[word]) + "]";
        between = ",\n";
    }
    text += "],\n\"calls\":[";
    between = "";
    for (const auto& [way, call] : calls_) {
        text += between + ("[" + std::to_string(way.first)) + "," + std::to_string(way.second) +
                "," + std::to_string(call.runs) + "," + std::to_string(call.cycles) + "]";
        between = ",\n";
    }
    return text + "]}\n";
}

}  // namespace simulator
