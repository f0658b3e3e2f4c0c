// SPDX-License-Identifier: GPL-3.0-or-later
// What a flight of chaos needs of a board beyond flying: restarts of its processor.
#pragma once
#include <memory>
#include <string>

#include "simulator/board.hpp"

namespace simulator::chaos {

class Drill {
public:
    virtual ~Drill() = default;
    virtual Board& board() = 0;
    // At once; false: there is no such restart.
    virtual void restart(const std::string& how) = 0;
};

// `firmware`: an .elf file on the emulated board; empty: natively compiled.
std::unique_ptr<Drill> makeDrill(const std::string& firmware, const WorldOptions& world);

}  // namespace simulator::chaos
