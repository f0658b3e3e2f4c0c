// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/vectors.hpp"

#include <algorithm>
#include <iterator>

namespace simulator {
namespace {

// Vectors of the ATmega2560, datasheet table 14-1, counted from 0 = reset.
struct Vector {
    int number;
    const char* name;
};
constexpr Vector kVectors[] = {{1, "INT0"},
                               {7, "INT6 data ready"},
                               {12, "watchdog"},
                               {13, "timer 2 compare A"},
                               {14, "timer 2 compare B"},
                               {15, "timer 2 overflow"},
                               {16, "timer 1 capture"},
                               {17, "timer 1 compare A"},
                               {20, "timer 1 overflow"},
                               {21, "timer 0 compare A"},
                               {22, "timer 0 compare B"},
                               {23, "timer 0 overflow"},
                               {24, "SPI"},
                               {25, "USART0 receive"},
                               {26, "USART0 transmit"},
                               {27, "USART0 sent"},
                               {29, "ADC"},
                               {30, "EEPROM ready"},
                               {31, "timer 3 capture"},
                               {32, "timer 3 compare A"},
                               {35, "timer 3 overflow"},
                               {36, "USART1 receive"},
                               {37, "USART1 transmit"},
                               {38, "USART1 sent"},
                               {39, "TWI"},
                               {41, "timer 4 capture"},
                               {42, "timer 4 compare A"},
                               {45, "timer 4 overflow"},
                               {46, "timer 5 capture"},
                               {47, "timer 5 compare A"},
                               {48, "timer 5 compare B"},
                               {49, "timer 5 compare C"},
                               {50, "timer 5 overflow"},
                               {51, "USART2 receive"},
                               {52, "USART2 transmit"},
                               {53, "USART2 sent"}};

}  // namespace

std::string vectorName(int vector) {
    const auto found = std::find_if(std::begin(kVectors), std::end(kVectors),
                                    [&](const Vector& v) { return v.number == vector; });
    return found == std::end(kVectors) ? "vector " + std::to_string(vector) : found->name;
}

}  // namespace simulator
