// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "simulator/output_file.hpp"
#include "toolchain/log_tool/program.hpp"

int main(int count, char** words) {
    return simulator::finishOutput("log",
                                   log_tool::run({words + 1, words + count}, std::cout, std::cerr));
}
