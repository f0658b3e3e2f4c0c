// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/safety/kept_home.hpp"

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
constexpr uint16_t kSealAt = kAt + offsetof(KeptHome, seal);
constexpr uint8_t kLogs = 4;  // the last bytes of the region are the log's
static_assert(sizeof(KeptHome) + kLogs <= storage::kHomeAndLog.size, "no room for the home");

uint16_t sum(const KeptHome& home) {
    return core::crc16(core::kCrcStart, &home, offsetof(KeptHome, seal));
}

Status write(uint16_t at, const void* from, uint8_t size) {
    storage::Owner owner;
    const Status status = storage::findOwner(owner);
    if (status != Status::ok) return status;
    if (owner != storage::Owner::us) return Status::ok;  // not to be written to
    return hal::eepromWrite(at, from, size);
}

}  // namespace

// The old seal does not fit the new place: a cut on the way leaves none.
Status keepHome(const geo::Position& position, int32_t altitude_cm) {
    KeptHome home = {position, altitude_cm, 0};
    home.seal = sum(home);
    return write(kAt, &home, sizeof home);
}

Status readHome(KeptHome& home) {
    const Status status = hal::eepromRead(kAt, &home, sizeof home);
    if (status != Status::ok) return status;
    return home.seal == sum(home) ? Status::ok : Status::corrupt;
}

Status forgetHome() {
    KeptHome home;
    const Status status = readHome(home);
    if (status != Status::ok) return status == Status::corrupt ? Status::ok : status;
    home.seal = static_cast<uint16_t>(~home.seal);
    return write(kSealAt, &home.seal, sizeof home.seal);
}

}  // namespace safety
}  // namespace firmware
