// SPDX-License-Identifier: GPL-3.0-or-later
// declination_table WMM.COF > libraries/geo/declination_table.hpp
#include <exception>
#include <fstream>
#include <iostream>

#include "toolchain/declination/table.hpp"

int main(int count, char** words) {
    try {
        if (count != 2) throw std::runtime_error("expected the file of the coefficients");
        std::ifstream file(words[1]);
        if (!file) throw std::runtime_error(std::string(words[1]) + ": cannot be read");
        std::cout << declination::tableHeader(declination::Model(file));
    } catch (const std::exception& error) {
        std::cerr << "declination_table: " << error.what() << '\n';
        return 1;
    }
}
