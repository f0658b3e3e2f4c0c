// SPDX-License-Identifier: GPL-3.0-or-later
// MAVLink 2's signatures, of what is received: while there is a key and SIGN_POLICY asks for it, a
// frame is obeyed when its signature is right and its time later than that of every frame before,
// in earlier starts too. https://mavlink.io/en/guide/message_signing.html
// What is sent: signing_outgoing.hpp.
#pragma once
#include <stdint.h>

#include "mavlink/frame.hpp"

namespace firmware {
namespace gcs {

struct Link;

// waits: for bytes of the signature, the EEPROM or the other link. works: a slice has been done.
enum class Verdict : uint8_t { waits, works, refused, obeyed };

void signingStart();
void signingTick();  // 50 times a second
// Of the frame that the link's parser holds; called until it is refused or obeyed.
Verdict signingVerdict(Link& link, const mavlink::Frame& frame);
void signingForget(Link& link);  // when it is, or is not waited for any more

bool onSetupSigning(Link& link, const mavlink::Frame& frame);
bool refuseSetupSigning(Link& link, const mavlink::Frame& frame);

}  // namespace gcs
}  // namespace firmware
