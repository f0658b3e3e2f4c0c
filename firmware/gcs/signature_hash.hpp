// SPDX-License-Identifier: GPL-3.0-or-later
// The hash of a signature, for one frame after the other: RAM has room for one. It is of the key,
// the frame, and link and time of its signature; a call does one slice, as a hash takes 3 to 5 ms.
#pragma once
#include <stdint.h>

#include "mavlink/frame.hpp"

namespace firmware {
namespace gcs {

struct __attribute__((packed)) Signature {
    uint8_t link;
    uint16_t lower;  // of the time
    uint32_t upper;
    uint8_t hash[6];
};
static_assert(sizeof(Signature) == mavlink::kSignature, "as it stands behind a frame");
constexpr uint8_t kSignatureHashed = 7;  // of its bytes: link and time

enum class HashUser : uint8_t { nobody, received, sent_on_link0, sent_on_link1 };
enum class Hashing : uint8_t { waits, works, done };

void signatureHashStart();
HashUser signatureHashUser();
// What is hashed behind the key, in two runs: frame, and link and time.
struct Hashed {
    const uint8_t* first;
    uint8_t first_size;
    const uint8_t* second;
    uint8_t size;  // of both
};
// waits: somebody else's hash, or the EEPROM with the key; works: a
// slice has been done; done: until it is released.
Hashing hashSignature(HashUser user, const Hashed& bytes);
uint8_t signatureHash(uint8_t at);  // byte 0 to 5, when it is done
void releaseSignatureHash(HashUser user);

}  // namespace gcs
}  // namespace firmware
