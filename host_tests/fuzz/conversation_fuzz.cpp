// SPDX-License-Identifier: GPL-3.0-or-later
// A whole conversation through both ports, from power-on: good frames of any message in any order,
// bytes that are none, pauses, and a port that has no room.
#include <string.h>

#include "vehicle.hpp"

namespace {

struct Rest {
    const uint8_t* bytes;
    size_t size;
    uint8_t take() {
        if (size == 0) return 0;
        --size;
        return *bytes++;
    }
};

void sayFrame(Rest& rest, uint8_t link, uint8_t kind) {
    const mavlink::Accepted accepted =
        mavlink::kAllMessages[kind % core::count(mavlink::kAllMessages)];
    uint8_t length = rest.take();
    const bool v1 = length & 0x80;
    length &= 0x3F;
    if (v1 && length < accepted.length) length = accepted.length;
    if (length == 0) length = 1;
    uint8_t payload[256] = {};
    for (uint8_t i = 0; i < length && rest.size > 0; ++i) payload[i] = rest.take();
    const mavlink::Sender sender = {v1 ? mavlink::Framing::v1 : mavlink::Framing::v2, 0, 255, 190};
    mavlink::writeFrame(
        [link](const uint8_t* bytes, uint8_t size) {
            fuzz::line(link).receive(std::vector<uint8_t>(bytes, bytes + size));
        },
        sender, {payload, accepted.id, length, accepted.crc_extra});
}

void sayAnything(Rest& rest, uint8_t link) {
    for (uint8_t count = rest.take() & 0x1F; count > 0 && rest.size > 0; --count)
        fuzz::line(link).in.push_back(rest.take());
}

constexpr uint8_t kAnything = 0x7F, kPause = 0x7E, kPose = 0x7D, kRoom = 0x7C;

void step(Rest& rest) {
    const uint8_t what = rest.take();
    const uint8_t link = what >> 7;
    switch (what & 0x7F) {
        case kAnything:
            return sayAnything(rest, link);
        case kPause:
            return fakes::advance_ms(100 * rest.take());
        case kPose:
            return fuzz::pose(rest.take());
        case kRoom:
            fuzz::line(link).room = rest.take() & 0x7F;
            return;
        default:
            return sayFrame(rest, link, what & 0x7F);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
    Rest rest = {bytes, size};
    fuzz::calm();
    firmware::gcs::telemetryStart();
    try {
        for (int i = 0; i < 8 && rest.size > 0; ++i) {
            step(rest);
            fuzz::turn();
        }
    } catch (const fakes::Rebooted&) {
        fuzz::start();
    }
    fuzz::checkAnswers();
    return 0;
}
