// SPDX-License-Identifier: GPL-3.0-or-later
// A bar on a terminal; elsewhere a line at every tenth.
#pragma once
#include <chrono>
#include <cstddef>
#include <string>

namespace simulator {

class Progress {
public:
    Progress(size_t flights, bool terminal) : flights_(flights), terminal_(terminal) {}

    void flown(bool well);
    void end() const;

private:
    std::string line() const;

    const size_t flights_;
    const bool terminal_;
    size_t flown_ = 0, failed_ = 0;
    std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

}  // namespace simulator
