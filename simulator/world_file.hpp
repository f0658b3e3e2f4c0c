// SPDX-License-Identifier: GPL-3.0-or-later
// The conditions of a flight as a file: place, air and every figure of the sensors' errors, as a
// JSON object of numbers. What a file leaves out stays as it is.
#pragma once
#include <stdexcept>
#include <string>

#include "simulator/world.hpp"

namespace simulator {

class WorldFileError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

// Throws WorldFileError with one line that names the file and what is wrong with it. What the
// mission's home decides, where the airplane stands and its heading, is not part of the file.
void readWorldFile(const std::string& path, WorldOptions& world);
std::string worldFileText(const WorldOptions& world);

}  // namespace simulator
