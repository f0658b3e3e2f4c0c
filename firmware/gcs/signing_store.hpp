// SPDX-License-Identifier: GPL-3.0-or-later
// What signed links keep in the EEPROM: the key, and times that are not to come again after a
// restart. A time is MAVLink's, 48 bits of 10 us since 2015, of which the upper 32 are stored:
// 0.655 s each. Each time is stored half a minute ahead, so that a write serves that long.
#pragma once
#include <stdint.h>

#include "core/status.hpp"
#include "mavlink/messages.hpp"

namespace firmware {
namespace gcs {

constexpr uint8_t kKeySize = 32;

enum class Key : uint8_t { unknown, none, set };
enum class Times : uint8_t { received, sent };

void signingStoreStart();
Key signingKey();   // unknown: the EEPROM was busy; asks again
bool signsLinks();  // there is a key, and SIGN_POLICY uses it
MUST_USE core::Status readSigningKey(uint8_t (&key)[kKeySize]);

// What was obeyed or sent is not later than this.
uint32_t storedTime(Times which);
bool storeAhead(Times which, uint32_t upper);  // false: the EEPROM is busy

// A new key, with the time at which it begins, in steps; of zeros: none from now on. busy: call it
// again with the same. Without its mark there is no key: a power cut leaves none.
MUST_USE core::Status storeSigningKey(const mavlink::SetupSigning& setup);
void giveUpSigningKey();  // what was begun; the next call begins anew
bool isZeroKey(const uint8_t (&key)[kKeySize]);

}  // namespace gcs
}  // namespace firmware
