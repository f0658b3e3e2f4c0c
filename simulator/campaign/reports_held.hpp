// SPDX-License-Identifier: GPL-3.0-or-later
// The reports of the worst flights stay, those of all others go: a thousand would fill a disk.
#pragma once
#include <cstddef>
#include <map>
#include <string>

namespace simulator {

class ReportsHeld {
public:
    explicit ReportsHeld(size_t places) : places_(places) {}

    // `badness`: larger is worse. The report that has to go for this one, or this one itself;
    // empty while there is room.
    std::string add(double badness, const std::string& report);

private:
    const size_t places_;
    std::multimap<double, std::string> held_;
};

}  // namespace simulator
