// SPDX-License-Identifier: GPL-3.0-or-later
// Where in the mission the airplane is, kept over a loss of power. One small entry a change, in
// places used in turn, so that the EEPROM outlives the airplane.
#pragma once
#include <stdint.h>

#include "core/status.hpp"

namespace storage {

class IndexStore {
public:
    // `generation`: the mission's; an index that belongs to another mission reads as 0. damaged:
    // where the next one goes stands no whole one; it may have been the newest, by a changed bit or
    // a cut, and the index is the one before. Until the next write.
    MUST_USE core::Status open(uint8_t generation, uint8_t& index, bool& damaged);
    MUST_USE core::Status write(uint8_t generation, uint8_t index);

private:
    uint8_t sequence_ = 0;  // of the newest
};

}  // namespace storage
