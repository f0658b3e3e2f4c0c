// SPDX-License-Identifier: GPL-3.0-or-later
// The tests' EEPROM: quick by default, on request as slow as the real one, and its power can be
// cut in the middle of a byte, which then reads 0xFF or noise (power.hpp).
#pragma once
#include <stdint.h>

#include <vector>

#include "fakes/power.hpp"

namespace fakes {

// As it comes from the factory: all 0xFF, quick, power on.
void resetEeprom();

// The cells themselves, as the next start would find them.
std::vector<uint8_t> eepromCells();
void setEepromCells(const std::vector<uint8_t>& cells);
void setEepromCell(uint16_t address, uint8_t value);
uint8_t eepromCell(uint16_t address);

// These bits of a cell stay as they are from now on, whatever is written; all wear is gone with
// resetEeprom().
void wearEepromCell(uint16_t address, uint8_t bits, bool high);

// Slow: a byte takes 3.4 ms of the fake clock, the queue holds hal::kEepromQueue bytes, and reads
// and writes answer busy by the contract's rules. Quick: everything is in its cell at once.
void setEepromSlow(bool slow);

// Power back on, as after a reset: what had not reached the cells is gone, no further cut.
void restartEeprom();

uint32_t eepromWrites();  // cell writes done since resetEeprom

}  // namespace fakes
