// SPDX-License-Identifier: GPL-3.0-or-later
#include "toolchain/mission_tool/airplane.hpp"

#include <cstring>
#include <filesystem>

#include "fakes/fakes.hpp"
#include "firmware/state/parameters.hpp"
#include "simulator/parameter_file.hpp"
#include "toolchain/mission_tool/wrong_input.hpp"

namespace mission_tool {
namespace {

bool set(const simulator::ParameterSetting& setting) {
    constexpr int kTicks = 1000;
    constexpr uint32_t kTurn_ms = 100;
    char name[16] = {};
    uint16_t index = 0;
    if (setting.name.size() > sizeof name) return false;
    std::memcpy(name, setting.name.data(), setting.name.size());
    if (!firmware::state::parameterFind(name, index)) return false;
    for (int turn = 0; turn < kTicks; ++turn) {
        const core::Status status =
            firmware::state::parameterSetAt(index, static_cast<float>(setting.value));
        if (status != core::Status::busy) return status == core::Status::ok;
        firmware::state::parametersRun();
        fakes::advance_ms(kTurn_ms);
    }
    return false;
}

}  // namespace

simulator::AirplaneParameters airplaneNamed(const std::string& name) {
    try {
        return simulator::loadAirplane(name);
    } catch (const simulator::AirplaneError& error) {
        throw WrongInput(error.what());
    }
}

void setParametersOf(const std::string& name) {
    const std::filesystem::path file =
        std::filesystem::path(simulator::airplanePath(name)).replace_extension(".param");
    if (!std::filesystem::exists(file)) return;
    try {
        for (const auto& each : simulator::readParameterFile(file))
            if (!set(each))
                throw WrongInput(file.string() + ": the firmware does not take " + each.name);
    } catch (const simulator::ParameterFileError& error) {
        throw WrongInput(error.what());
    }
}

}  // namespace mission_tool
