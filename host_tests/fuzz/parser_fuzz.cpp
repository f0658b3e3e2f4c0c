// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes into the parsers of both ends. Whatever they were: nothing is taken for a frame whose
// checksum does not say so, and good frames that follow are understood but for those the bytes
// before them laid claim to.
#include <stdlib.h>

#include "firmware/gcs/link.hpp"
#include "mavlink/peer.hpp"

namespace {

using VehicleParser =
    mavlink::Parser<firmware::gcs::IncomingTable, firmware::gcs::kLongestQuestion>;

void require(bool holds) {
    if (!holds) abort();
}

// The frame as it must have stood on the wire, but for the flags that say nothing of its contents.
void check(const mavlink::Frame& frame, const uint8_t* header, uint8_t header_size) {
    uint16_t crc = core::crc16(core::kCrcStart, header + 1, header_size - 1);
    crc = core::crc16(crc, frame.payload, frame.length);
    mavlink::Accepted accepted;
    bool known = false;
    for (const mavlink::Accepted& each : mavlink::kAllMessages)
        if (each.id == frame.id) known = true, accepted = each;
    require(known);
    crc = core::crc16(crc, accepted.crc_extra);
    require(frame.payload[frame.length] == (crc & 0xFF));
    require(frame.payload[frame.length + 1] == crc >> 8);
}

template <class Parser>
uint32_t feed(Parser& parser, const uint8_t* bytes, size_t size) {
    uint32_t frames = 0;
    for (size_t i = 0; i < size; ++i)
        for (bool whole = parser.put(bytes[i]); whole; whole = parser.next()) {
            const mavlink::Frame frame = parser.frame();
            const uint8_t header =
                frame.framing == mavlink::Framing::v1 ? mavlink::kHeaderV1 : mavlink::kHeaderV2;
            check(frame, frame.payload - header, header);
            ++frames;
        }
    return frames;
}

template <class Parser>
void tryOut(const uint8_t* bytes, size_t size, uint16_t longest) {
    uint8_t good[mavlink::kLongestFrame];
    const uint16_t good_size = mavlink::encode({mavlink::Framing::v1, 7, 255, 190},
                                               mavlink::Heartbeat{6, 0, 0, 8, 0, 3}, good);
    Parser parser;
    feed(parser, bytes, size);
    const uint32_t wanted = 2, lost = (longest + mavlink::kSignature) / good_size + 1;
    uint32_t heard = 0;
    for (uint32_t i = 0; i < wanted + lost; ++i) heard += feed(parser, good, good_size);
    require(heard >= wanted);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* bytes, size_t size) {
    const bool vehicles = size == 0 || bytes[0] != 0;
    if (vehicles) {
        tryOut<VehicleParser>(bytes, size, firmware::gcs::kLongestQuestion);
    } else {
        tryOut<mavlink::PeerParser>(bytes + 1, size - 1, mavlink::kLongestFrame);
    }
    return 0;
}
