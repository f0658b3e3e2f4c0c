// SPDX-License-Identifier: GPL-3.0-or-later
// Any payload into the handler of one message, FUZZ_MESSAGE by its number: how the vehicle is,
// which framing, then the payload.
#include <string.h>

#include "vehicle.hpp"

namespace {

uint8_t row;
mavlink::Accepted accepted;

constexpr uint8_t kLongestPayload =
    firmware::gcs::kLongestQuestion - mavlink::kHeaderV1 - mavlink::kChecksum;

mavlink::Frame frameOf(uint8_t how, const uint8_t* payload, uint8_t length) {
    mavlink::Frame frame = {};
    frame.payload = payload;
    frame.id = accepted.id;
    frame.length = length;
    frame.row = row;
    frame.framing = how & 8 ? mavlink::Framing::v2 : mavlink::Framing::v1;
    frame.system = how & 16 ? 255 : 42;
    frame.component = 190;
    return frame;
}

// True: the vehicle is still running.
bool handle(firmware::gcs::Link& link, const mavlink::Frame& frame, bool then) {
    try {
        link.framing = frame.framing;
        if (!firmware::gcs::handleFrame(link, frame)) {
            fuzz::turn();
            if (!firmware::gcs::handleFrame(link, frame)) firmware::gcs::refuseFrame(link, frame);
        }
        if (then) fuzz::turn();
        return true;
    } catch (const fakes::Rebooted&) {
        return false;
    }
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    fuzz::start();
    const char* number = getenv("FUZZ_MESSAGE");
    fuzz::require(number != nullptr);
    row = firmware::gcs::IncomingTable::find(static_cast<uint16_t>(atoi(number)), accepted);
    fuzz::require(row != mavlink::kNoRow);
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
    if (size < 2) return -1;
    const uint8_t how = bytes[0];
    size_t length = size - 1;
    if (length > kLongestPayload) length = kLongestPayload;
    const bool v1 = !(how & 8);
    if (v1 && length < accepted.length) length = accepted.length;
    // of exactly this size, so that a read past its end is seen
    const std::unique_ptr<uint8_t[]> payload(new uint8_t[length]());
    memcpy(payload.get(), bytes + 1, size - 1 < length ? size - 1 : length);

    fuzz::calm();
    fuzz::pose(how);
    firmware::gcs::Link& link = firmware::gcs::links[how >> 7];
    if (!handle(link, frameOf(how, payload.get(), static_cast<uint8_t>(length)), how & 32))
        fuzz::start();
    fuzz::checkAnswers();
    return 0;
}
