// SPDX-License-Identifier: GPL-3.0-or-later
// Reads frames from standard input and writes each of them again, as `repeat 1|2` says in MAVLink
// 1 or 2: what an independent client wrote goes through our parser and our writer.
#include <cstdio>
#include <cstring>

#include "mavlink/peer.hpp"

int main(int count, char** arguments) {
    if (count != 2) return 2;
    const auto framing =
        std::strcmp(arguments[1], "1") == 0 ? mavlink::Framing::v1 : mavlink::Framing::v2;
    mavlink::PeerParser parser;
    for (int c; (c = std::getchar()) != EOF;)
        for (bool whole = parser.put(static_cast<uint8_t>(c)); whole; whole = parser.next()) {
            const mavlink::Frame frame = parser.frame();
            const mavlink::Accepted accepted = mavlink::kAllMessages[frame.row];
            uint8_t payload[255];
            frame.copyPayload(payload, sizeof payload);
            const uint8_t length = framing == mavlink::Framing::v1
                                       ? accepted.length
                                       : mavlink::withoutTrailingZeros(payload, sizeof payload);
            mavlink::writeFrame(
                [](const uint8_t* bytes, uint8_t size) { std::fwrite(bytes, 1, size, stdout); },
                {framing, frame.sequence, frame.system, frame.component},
                {payload, frame.id, length, accepted.crc_extra});
        }
    std::fprintf(stderr, "%u\n", static_cast<unsigned>(parser.rejected()));
}
