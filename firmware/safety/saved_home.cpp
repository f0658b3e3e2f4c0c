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
constexpr uint8_t kChecksumAt = offsetof(SavedHome, checksum);
constexpr uint8_t kLogs = 4;  // the last bytes of the region are the log's
static_assert(2 * sizeof(SavedHome) + kLogs <= storage::kHomeAndLog.size, "no room for two homes");
static_assert(2 * sizeof(SavedHome) <= hal::kEepromQueue, "both are queued in one piece");

uint16_t sum(const SavedHome& home) { return core::crc16(core::kCrcStart, &home, kChecksumAt); }

uint16_t forgotten(const SavedHome& home) { return static_cast<uint16_t>(~sum(home)); }

Status readBoth(SavedHome (&homes)[2]) { return hal::eepromRead(kAt, homes, sizeof homes); }

Status writeBoth(const SavedHome (&homes)[2]) {
    return storage::writeIfOurs(kAt, homes, sizeof homes);
}

}  // namespace

// The old checksum does not fit the new place: a cut on the way leaves none, or the second one,
// which then is still the old.
Status saveHome(const geo::Position& position, int32_t altitude_cm) {
    SavedHome home = {position, altitude_cm, 0};
    home.checksum = sum(home);
    const SavedHome homes[2] = {home, home};
    return writeBoth(homes);
}

// The second one counts where the first is damaged; in what has only one it is blank.
Status readHome(SavedHome& home) {
    SavedHome homes[2];
    const Status status = readBoth(homes);
    if (status != Status::ok) return status;
    const bool damaged =
        homes[0].checksum != sum(homes[0]) && homes[0].checksum != forgotten(homes[0]);
    home = homes[damaged];
    return home.checksum == sum(home) ? Status::ok : Status::corrupt;
}

Status forgetHome() {
    SavedHome homes[2];
    const Status status = readBoth(homes);
    if (status != Status::ok) return status;
    for (SavedHome& home : homes) home.checksum = forgotten(home);
    return writeBoth(homes);
}

}  // namespace safety
}  // namespace firmware
