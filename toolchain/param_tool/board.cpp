// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/param_tool/board.hpp"

#include <cmath>
#include <cstring>
#include <map>

#include "fakes/fakes.hpp"
#include "firmware/state/parameters.hpp"
#include "toolchain/mission_tool/board.hpp"
#include "toolchain/mission_tool/wrong_input.hpp"

namespace param_tool {
namespace {

using core::Status;
using mission_tool::expected;
using mission_tool::placed;

constexpr int kTicks = 1000;
constexpr uint32_t kTurn_ms = 100;
constexpr uint8_t kReal32 = 9;  // MAV_PARAM_TYPE

bool indexOf(const std::string& name, uint16_t& index) {
    char padded[16] = {};
    if (name.size() > sizeof padded) return false;
    std::memcpy(padded, name.data(), name.size());
    return firmware::state::parameterFind(padded, index);
}

Parameter at(uint16_t index) {
    char name[16];
    uint8_t type = 0;
    firmware::state::ParameterLimits limits{};
    Parameter parameter{};
    (void)firmware::state::parameterAt(index, name, parameter.value, type);
    (void)firmware::state::parameterLimits(index, limits);
    parameter.name.assign(name, strnlen(name, sizeof name));
    parameter.initial = limits.initial;
    parameter.lowest = limits.lowest;
    parameter.highest = limits.highest;
    parameter.stored = limits.stored;
    parameter.whole = type != kReal32;
    return parameter;
}

Status setAt(uint16_t index, float value) {
    for (int turn = 0; turn < kTicks; ++turn) {
        const Status status = firmware::state::parameterSetAt(index, value);
        if (status != Status::busy) return status;
        firmware::state::parametersRun();
        fakes::advance_ms(kTurn_ms);
    }
    throw mission_tool::WrongInput("the firmware's parameter store does not answer");
}

std::string refusal(const Parameter& parameter, float value) {
    if (value >= parameter.lowest && value <= parameter.highest)
        return "a value that means something to this firmware";
    return "a number from " + spelled(parameter.lowest) + " to " + spelled(parameter.highest);
}

}  // namespace

void powerUp(const mission_tool::Image& image, const std::string& name) {
    mission_tool::boot(image, name);
}

std::vector<Parameter> parameters() {
    std::vector<Parameter> all;
    for (uint16_t index = 0; index < firmware::state::parameterCount(); ++index)
        all.push_back(at(index));
    return all;
}

void set(const std::vector<Setting>& settings, const std::string& file, const Rules& rules,
         std::vector<Finding>& findings) {
    std::map<std::string, int> named;
    for (const Setting& setting : settings) {
        const auto report = [&](bool error, int column, const std::string& text) {
            findings.push_back(
                {setting.line, error,
                 placed(file, setting.line, column, (error ? "" : "warning: ") + text)});
        };
        uint16_t index = 0;
        const auto [first, fresh] = named.emplace(setting.name, setting.line);
        if (!fresh) {
            report(true, setting.name_column,
                   setting.name + " stands in line " + std::to_string(first->second) + " already");
        } else if (!indexOf(setting.name, index)) {
            report(!rules.skip_unknown, setting.name_column,
                   expected("a parameter of this firmware", setting.name));
        } else if (!at(index).stored) {
            if (setting.value != 0)
                report(false, setting.name_column,
                       setting.name +
                           " is left out: it is as long as the list of points, which "
                           "goes up by itself");
        } else {
            const float value = static_cast<float>(setting.value);
            const Status status = setAt(index, value);
            if (status != Status::ok)
                report(true, setting.value_column,
                       expected(refusal(at(index), value), spelled(value)));
            else if (at(index).whole && std::trunc(value) != value)
                report(
                    false, setting.value_column,
                    "a whole number: " + spelled(value) + " becomes " + spelled(at(index).value));
        }
    }
}

mission_tool::Image image() { return fakes::eepromCells(); }

}  // namespace param_tool
