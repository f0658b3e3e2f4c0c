// SPDX-License-Identifier: GPL-3.0-or-later
#include "storage/log_base.hpp"

#include "hal/eeprom.hpp"
#include "storage/eeprom_map.hpp"
#include "storage/owner.hpp"

namespace storage {
namespace {

using core::Status;

// The page, in its lowest bit, which is 0 in a multiple of 8, the parity of the others; and the
// complement of that. Where the two differ, the one of even parity is right. The first boards
// stored no parity.
struct Stored {
    uint16_t word, complement;
};
constexpr uint16_t kAt = kHomeAndLog.end() - sizeof(Stored);
constexpr uint16_t kMultiple = 8;

}  // namespace

Status readLogBase(uint16_t& page) {
    Stored stored;
    const Status status = hal::eepromRead(kAt, &stored, sizeof stored);
    if (status != Status::ok) return status;
    const uint16_t other = static_cast<uint16_t>(~stored.complement);
    const bool odd = __builtin_parity(stored.word) != 0;
    page = (odd ? other : stored.word) & ~(kMultiple - 1U);
    return status;
}

Status writeLogBase(uint16_t page) {
    const uint16_t word = static_cast<uint16_t>(page | __builtin_parity(page));
    const Stored stored = {word, static_cast<uint16_t>(~word)};
    return writeIfOurs(kAt, &stored, sizeof stored);
}

}  // namespace storage
