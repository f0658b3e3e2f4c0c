// SPDX-License-Identifier: GPL-3.0-or-later
// The airplane that a mission is for: its model, and the parameters that it flies with.
#pragma once
#include <string>

#include "simulator/airplane/parameters.hpp"

namespace mission_tool {

constexpr char kUsualAirplane[] = "foam_trainer";

// A name of simulator/airplanes, or the path of a .json file. Throws WrongInput.
simulator::AirplaneParameters airplaneNamed(const std::string& name);

// Sets the parameters of the .param file beside the model, where there is one, on the board that
// runs (board.hpp). Throws WrongInput.
void setParametersOf(const std::string& name);

}  // namespace mission_tool
