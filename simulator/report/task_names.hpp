// SPDX-License-Identifier: GPL-3.0-or-later
// What the firmware calls its tasks, from the file tasks.json that our build lays beside the image
// (toolchain/schedule/task_rows.mjs). The board knows them only by number.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace simulator {

struct TaskName {
    int number;
    std::string name;
    uint32_t period;  // frames
    uint32_t budget_us;
    std::string tier;
};

// Empty when there is no such file, or none that can be understood.
std::vector<TaskName> readTaskNames(const std::filesystem::path& firmware);

// nullptr: the task has no name.
const TaskName* find(const std::vector<TaskName>& names, int number);

}  // namespace simulator
