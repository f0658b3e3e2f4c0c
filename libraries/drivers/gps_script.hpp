// SPDX-License-Identifier: GPL-3.0-or-later
// What is sent to GPS receivers, put together with checksums by the compiler: UBX frames (u-blox 6
// Receiver Description, "UBX Protocol") and PMTK sentences (MediaTek's, with those of the
// DIYDrones firmware).
#pragma once
#include <stddef.h>
#include <stdint.h>

namespace drivers {

struct GpsScript {
    static constexpr uint8_t kCapacity = 128;
    uint8_t bytes[kCapacity] = {};
    uint8_t size = 0;

    constexpr void put(uint8_t byte) { bytes[size++] = byte; }

    // A UBX frame; what `payload` does not give of `length` is zero.
    template <size_t N>
    constexpr void message(uint8_t of_class, uint8_t id, uint8_t length,
                           const uint8_t (&payload)[N]) {
        put(0xB5);
        put(0x62);
        const uint8_t summed = size;
        put(of_class);
        put(id);
        put(length);
        put(0);
        for (uint8_t i = 0; i < length; ++i) put(i < N ? payload[i] : 0);
        uint8_t a = 0, b = 0;
        for (uint8_t i = summed; i < size; ++i) {
            a = static_cast<uint8_t>(a + bytes[i]);
            b = static_cast<uint8_t>(b + a);
        }
        put(a);
        put(b);
    }
    constexpr void endLine() {
        put('\r');
        put('\n');
    }
    // What stands between '$' and '*'.
    template <size_t N>
    constexpr void sentence(const char (&body)[N]) {
        constexpr char kDigits[] = "0123456789ABCDEF";
        uint8_t sum = 0;
        put('$');
        for (size_t i = 0; i + 1 < N; ++i) {
            put(static_cast<uint8_t>(body[i]));
            sum = static_cast<uint8_t>(sum ^ static_cast<uint8_t>(body[i]));
        }
        put('*');
        put(static_cast<uint8_t>(kDigits[sum >> 4]));
        put(static_cast<uint8_t>(kDigits[sum & 15]));
        endLine();
    }
};

constexpr uint8_t kAirborne4g = 8;

// Sent at every rate the receiver may listen at: talk UBX at 38400 from now on. Once as UBX
// (CFG-PRT: UART 1, 8N1, in UBX and NMEA, out UBX) and once for those that only take text. What was
// sent at another rate may have looked like the beginning of a sentence: a line's end comes first.
constexpr GpsScript ubloxGreeting() {
    GpsScript script;
    constexpr uint8_t port[] = {1, 0, 0, 0, 0xD0, 0x08, 0, 0, 0x00, 0x96, 0, 0, 3, 0, 1};
    script.endLine();
    script.message(0x06, 0x00, 20, port);
    script.sentence("PUBX,41,1,0003,0001,38400,0");
    return script;
}

// All that the two scripts below ask for, for receivers that take CFG-VALSET: the M9, and the M10,
// which takes nothing else (M10 SPG 5.10 Interface Description, UBX-21035062, chapter 6). Into the
// RAM; older ones refuse it. NAV-PVT is one message with all of an epoch.
constexpr GpsScript ubloxValues() {
    GpsScript script;
    constexpr uint8_t values[] = {
        0,    1,    0,    0,                              // version, layer
        0x01, 0x00, 0x74, 0x10, 1,                        // CFG-UART1OUTPROT-UBX
        0x02, 0x00, 0x74, 0x10, 0,                        // CFG-UART1OUTPROT-NMEA
        0x01, 0x00, 0x21, 0x30, 200,         0,           // CFG-RATE-MEAS
        0x07, 0x00, 0x91, 0x20, 1,                        // CFG-MSGOUT-UBX_NAV_PVT_UART1
        0x21, 0x00, 0x11, 0x20, kAirborne4g,              // CFG-NAVSPG-DYNMODEL
        0x01, 0x00, 0x52, 0x40, 0x00,        0x96, 0, 0,  // CFG-UART1-BAUDRATE
    };
    script.endLine();
    script.message(0x06, 0x8A, sizeof values, values);
    return script;
}

// 5 Hz; NAV-POSLLH, STATUS, SOL and VELNED once an epoch; dynamic model airborne < 4 g.
constexpr GpsScript ubloxConfiguration() {
    GpsScript script;
    constexpr uint8_t rate[] = {200, 0, 1, 0, 0, 0};
    constexpr uint8_t position[] = {0x01, 0x02, 1}, status[] = {0x01, 0x03, 1};
    constexpr uint8_t solution[] = {0x01, 0x06, 1}, velocity[] = {0x01, 0x12, 1};
    constexpr uint8_t model[] = {0x01, 0, kAirborne4g};  // mask: the model alone
    script.endLine();
    script.message(0x06, 0x08, 6, rate);
    script.message(0x06, 0x01, 3, position);
    script.message(0x06, 0x01, 3, status);
    script.message(0x06, 0x01, 3, solution);
    script.message(0x06, 0x01, 3, velocity);
    script.message(0x06, 0x24, 36, model);
    return script;
}

// Asks for the navigation settings, to see whether the model still holds.
constexpr GpsScript ubloxQuestion() {
    GpsScript script;
    constexpr uint8_t none[] = {0};
    script.message(0x06, 0x24, 0, none);
    return script;
}

// 5 Hz, the binary message, 38400 baud; where there is no such message it stays with NMEA.
constexpr GpsScript mtkGreeting() {
    GpsScript script;
    script.endLine();
    script.sentence("PMTK220,200");
    script.sentence("PGCMD,16,0,0,0,0,0");
    script.sentence("PMTK251,38400");
    return script;
}

// The same, and corrections from satellites, at standstill too: no threshold of speed.
constexpr GpsScript mtkConfiguration() {
    GpsScript script = mtkGreeting();
    script.sentence("PMTK313,1");
    script.sentence("PMTK301,2");
    script.sentence("PMTK397,0");
    return script;
}

}  // namespace drivers
