// SPDX-License-Identifier: GPL-3.0-or-later
// A .param file, read as toolchain/param reads it.
#pragma once
#include <stdexcept>
#include <string>

#include "simulator/ground/parameter_upload.hpp"

namespace simulator {

class ParameterFileError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

ParameterSettings readParameterFile(const std::string& path);  // throws ParameterFileError

}  // namespace simulator
