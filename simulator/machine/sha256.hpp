// SPDX-License-Identifier: GPL-3.0-or-later
// SHA-256 (FIPS 180-4): by it a file is known again.
#pragma once
#include <string>

namespace simulator {

std::string sha256(const std::string& bytes);  // 64 lower-case hexadecimal digits

}  // namespace simulator
