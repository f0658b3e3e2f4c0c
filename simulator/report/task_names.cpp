// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/task_names.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

namespace simulator {

std::vector<TaskName> readTaskNames(const std::filesystem::path& firmware) {
    std::ifstream file(std::filesystem::path(firmware).replace_filename("tasks.json"));
    if (!file) return {};
    std::vector<TaskName> names;
    try {
        for (const auto& row : nlohmann::json::parse(file)) {
            names.push_back({row.at("number"), row.at("name"), row.at("period"),
                             row.at("budget_us"), row.at("tier")});
        }
    } catch (const nlohmann::json::exception&) {
        return {};
    }
    return names;
}

const TaskName* find(const std::vector<TaskName>& names, int number) {
    const auto found = std::find_if(names.begin(), names.end(),
                                    [&](const TaskName& name) { return name.number == number; });
    return found == names.end() ? nullptr : &*found;
}

}  // namespace simulator
