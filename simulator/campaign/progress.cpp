// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/campaign/progress.hpp"

#include <cstdio>
#include <iostream>

namespace simulator {

std::string Progress::line() const {
    constexpr size_t kWidth = 30;
    const size_t full = flown_ * kWidth / flights_;
    const double gone_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begun_).count();
    const double left_s =
        gone_s / static_cast<double>(flown_) * static_cast<double>(flights_ - flown_);
    char text[120];
    std::snprintf(text, sizeof text, "[%s%s] %zu/%zu  %zu failed  %d:%02d to go",
                  std::string(full, '#').c_str(), std::string(kWidth - full, '.').c_str(), flown_,
                  flights_, failed_, static_cast<int>(left_s) / 60, static_cast<int>(left_s) % 60);
    return text;
}

void Progress::flown(bool well) {
    constexpr size_t kLines = 10;
    const size_t before = flown_ * kLines / flights_;
    ++flown_;
    if (!well) ++failed_;
    if (terminal_) {
        std::cout << "\r" << line() << "   " << std::flush;
    } else if (flown_ * kLines / flights_ != before) {
        std::cout << line() << std::endl;
    }
}

void Progress::end() const {
    if (terminal_ && flown_ > 0) std::cout << "\n";
    std::cout << std::endl;
}

}  // namespace simulator
