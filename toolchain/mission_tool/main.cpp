// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "simulator/output_file.hpp"
#include "toolchain/mission_tool/program.hpp"

int main(int count, char** words) {
    return simulator::finishOutput(
        "mission", mission_tool::run({words + 1, words + count}, std::cout, std::cerr));
}
