// SPDX-License-Identifier: GPL-3.0-or-later
// What a u-blox module understands on its serial line: UBX frames and NMEA sentences with a right
// checksum; anything else is skipped.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace simulator {

struct UbxFrame {
    uint8_t message_class = 0, id = 0;
    std::vector<uint8_t> payload;

    uint32_t u32(size_t at) const;
    uint16_t u16(size_t at) const;
};

// Sync, header, payload, checksum as they go over the line.
std::vector<uint8_t> ubxBytes(const UbxFrame& frame);
// `body` between '$' and '*', with both, the checksum and the line end.
std::string nmeaSentence(const std::string& body);

class UbloxParser {
public:
    // At most one of the two is whole after a byte.
    void take(uint8_t byte);
    std::optional<UbxFrame> frame();        // the body of a good frame, once
    std::optional<std::string> sentence();  // between '$' and '*', once

private:
    void takeUbx();
    void takeNmea();

    std::vector<uint8_t> bytes_;
    std::optional<UbxFrame> frame_;
    std::optional<std::string> sentence_;
};

}  // namespace simulator
