// SPDX-License-Identifier: GPL-3.0-or-later
// The GPS, whatever it is and at whatever rate it talks: found by itself, configured to send five
// fixes a second in its own binary protocol at 38400 baud where it takes that, configured again
// when it forgets, and looked for again when it falls silent. docs/boards.md has the search step by
// step.
#pragma once
#include "drivers/gps_epoch.hpp"
#include "drivers/gps_framing.hpp"

namespace drivers {

// What the receiver is said to be: GPS_TYPE.
enum GpsType : uint8_t {
    gps_none,
    gps_any,
    gps_ublox,
    gps_mtk16,
    gps_mtk19,
    gps_nmea,
};

class Gps {
public:
    void start(uint8_t type = gps_any);
    // Every frame, and sooner when much waits; reads at most kBytesPerStep bytes. True: fix() is
    // new and whole. Its type may be `none`: then only type and satellites mean anything.
    bool step(uint32_t now_ms);

    const GpsFix& fix() const { return epoch_.fix; }
    bool healthy() const { return found_ != GpsProtocol::none; }  // talks; may have no fix
    GpsProtocol protocol() const { return found_; }
    uint32_t baud() const;  // of the port
    // Messages that were damaged, or right and impossible.
    uint16_t refused() const;

    static constexpr uint8_t kBytesPerStep = 48;  // 38400 baud bring 38 in 10 ms

private:
    enum class State : uint8_t { idle, greet, call, listen, run };

    void greet(uint16_t now);
    void call(uint16_t now);
    void listen(uint16_t now);
    void goOn(uint16_t now);
    void watch(uint16_t now);
    void queue(uint8_t scripts);
    void send();
    bool configured() const { return waiting_ == 0 && script_left_ == 0; }
    bool heard(GpsProtocol protocol, uint16_t now);
    bool counts(GpsProtocol protocol) const;
    void adopt(GpsProtocol protocol, uint16_t now);

    GpsFraming framing_;
    GpsEpoch epoch_ = {};
    const uint8_t* script_ = nullptr;  // in flash, still to be sent
    // Milliseconds, wrapping after a minute: nothing here takes longer than half of one.
    uint16_t since_ = 0;    // the state was entered or the receiver heard
    uint16_t stepped_ = 0;  // an epoch came 200 ms after the one before
    uint16_t asked_ = 0;    // the receiver was last spoken to, beyond its configuration
    uint16_t burst_ = 0;    // bytes since the line was last at rest
    uint8_t script_left_ = 0;
    uint8_t waiting_ = 0;  // scripts, a bit each
    uint8_t type_ = gps_none;
    uint8_t round_ = 0;      // the rate being tried
    uint8_t greetings_ = 0;  // owed to an NMEA receiver that may be able to do better
    GpsProtocol found_ = GpsProtocol::none, candidate_ = GpsProtocol::none;
    State state_ = State::idle;
};

}  // namespace drivers
