// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/gps_framing.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using drivers::GpsFraming;
using drivers::GpsProtocol;
using Bytes = std::vector<uint8_t>;

Bytes operator+(Bytes a, const Bytes& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}
Bytes text(const std::string& line) { return Bytes(line.begin(), line.end()); }

// The published request for NAV-SOL (CFG-MSG) and an MTK message of zeros.
const Bytes kUbx = {0xB5, 0x62, 0x06, 0x01, 0x03, 0x00, 0x01, 0x06, 0x01, 0x12, 0x4F};
const Bytes kGga = text("$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\r\n");
Bytes mtk(uint8_t first) {
    Bytes bytes = {first, 0xDD, 32};
    bytes.resize(3 + 32);
    bytes[20] = 0xB5;
    uint8_t a = 0, b = 0;
    for (size_t i = 2; i < bytes.size(); ++i) b = uint8_t(b + (a = uint8_t(a + bytes[i])));
    return bytes + Bytes{a, b};
}

struct Framing : ::testing::Test {
    GpsFraming framing;
    std::vector<GpsProtocol> heard(const Bytes& bytes) {
        std::vector<GpsProtocol> found;
        for (uint8_t byte : bytes)
            for (auto p = framing.put(byte); p != GpsProtocol::none; p = framing.next())
                found.push_back(p);
        return found;
    }
};
using Found = std::vector<GpsProtocol>;

TEST_F(Framing, finds_the_messages_of_every_protocol_in_one_stream) {
    EXPECT_EQ(heard(kUbx + mtk(0xD0) + kGga + mtk(0xD1) + kUbx + kUbx + kGga),
              (Found{GpsProtocol::ublox, GpsProtocol::mtk16, GpsProtocol::nmea, GpsProtocol::mtk19,
                     GpsProtocol::ublox, GpsProtocol::ublox, GpsProtocol::nmea}));
    EXPECT_EQ(framing.refused(), 0);
}

TEST_F(Framing, takes_checksums_in_small_letters_and_lines_ended_by_one_character) {
    EXPECT_EQ(heard(text("$GNGSA,A,1,,,,,,,,,,,,,,,*00\n")).size(), 1u);
    EXPECT_EQ(heard(text("$GPGLL,,,,,,V,N*64\r")).size(), 1u);
    EXPECT_EQ(heard(text("$GPVTG,,T,,M,,N,,K,N*2c\r\n")).size(), 1u);
}

TEST_F(Framing, loses_nothing_that_stands_behind_a_message_cut_short) {
    for (const Bytes& whole : {kUbx, mtk(0xD0), kGga})
        for (size_t size = 1; size < whole.size(); ++size)
            for (const Bytes& next : {kUbx, mtk(0xD1), kGga}) {
                framing.clear();
                const Bytes cut(whole.begin(), whole.begin() + static_cast<long>(size));
                const Bytes all = cut + next + kGga + kGga;
                const bool cut_by_line_end = size + 1 == whole.size() && whole == kGga;
                EXPECT_EQ(heard(all).size(), cut_by_line_end ? 4u : 3u)
                    << size << " of " << whole.size();
            }
}

TEST_F(Framing, refuses_a_message_with_any_bit_turned_over) {
    for (const Bytes& whole : {kUbx, mtk(0xD0)})
        for (size_t bit = 0; bit < whole.size() * 8; ++bit) {
            framing.clear();
            Bytes bad = whole;
            bad[bit / 8] = static_cast<uint8_t>(bad[bit / 8] ^ 1u << bit % 8);
            const Found found = heard(bad + kGga + kGga);
            // D0 and D1 are a bit apart, and the sums do not cover them
            const bool other = bit == 0 && whole != kUbx;
            EXPECT_EQ(found.size(), other ? 3u : 2u) << bit;
        }
}

TEST_F(Framing, counts_what_it_refuses_and_not_noise) {
    heard({0xB5, 0xB5, 0x62, 0xFF, 0xFF, 0xFF, 0xFF, '$', 'G', 'P', 0xB5, 0x00});
    EXPECT_EQ(framing.refused(), 0);
    heard(text("$GPGGA,1,2,3*00\r\n"));
    heard(text("$GPGGA,1,2\x80,3*00\r\n"));
    heard(text("$GPGGA,no checksum\r\n"));
    EXPECT_EQ(framing.refused(), 3);
}

TEST_F(Framing, refuses_a_sentence_that_never_ends) {
    EXPECT_TRUE(heard(text("$GPGGA," + std::string(1000, '1'))).empty());
    EXPECT_EQ(framing.refused(), 1);
    EXPECT_EQ(heard(kGga).size(), 1u);
}

TEST_F(Framing, refuses_a_length_no_message_has) {
    EXPECT_EQ(heard(Bytes{0xB5, 0x62, 0x01, 0x02, 0x00, 0x01} + kUbx).size(), 1u);
    EXPECT_EQ(heard(Bytes{0xB5, 0x62, 0x01, 0x30, 93, 0x00} + kUbx).size(), 1u);
    EXPECT_EQ(heard(Bytes{0xD0, 0xDD, 33} + mtk(0xD0)).size(), 1u);
}

}  // namespace
