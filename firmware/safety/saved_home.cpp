// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/saved_home.hpp"

#include <stddef.h>

#include "core/crc.hpp"
#include "hal/eeprom.hpp"
#include "storage/eeprom_map.hpp"
#include "storage/owner.hpp"

namespace firmware {
namespace safety {

namespace {

using core::Status;

constexpr uint16_t kAt = storage::kHomeAndLog.begin;
constexpr uint16_t kChecksumAt = kAt + offsetof(SavedHome, checksum);
constexpr uint8_t kLogs = 4;  // the last bytes of the region are the log's
static_assert(sizeof(SavedHome) + kLogs <= storage::kHomeAndLog.size, "no room for the home");

uint16_t sum(const SavedHome& home) {
    return core::crc16(core::kCrcStart, &home, offsetof(SavedHome, checksum));
}

Status write(uint16_t at, const void* from, uint8_t size) {
    storage::Owner owner;
    const Status status = storage::findOwner(owner);
    if (status != Status::ok) return status;
    if (owner != storage::Owner::ours) return Status::ok;  // not to be written to
    return hal::eepromWrite(at, from, size);
}

}  // namespace

// The old checksum does not fit the new place: a cut on the way leaves none.
Status saveHome(const geo::Position& position, int32_t altitude_cm) {
    SavedHome home = {position, altitude_cm, 0};
    home.checksum = sum(home);
    return write(kAt, &home, sizeof home);
}

Status readHome(SavedHome& home) {
    const Status status = hal::eepromRead(kAt, &home, sizeof home);
    if (status != Status::ok) return status;
    return home.checksum == sum(home) ? Status::ok : Status::corrupt;
}

Status forgetHome() {
    SavedHome home;
    const Status status = readHome(home);
    if (status != Status::ok) return status == Status::corrupt ? Status::ok : status;
    home.checksum = static_cast<uint16_t>(~home.checksum);
    return write(kChecksumAt, &home.checksum, sizeof home.checksum);
}

}  // namespace safety
}  // namespace firmware
