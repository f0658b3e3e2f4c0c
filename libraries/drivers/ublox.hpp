// SPDX-License-Identifier: GPL-3.0-or-later
// u-blox GPS in its UBX protocol: found at whatever rate it talks, set to 38400 baud, 5 Hz and the
// airborne model, and set again when it forgets. Parsed as a stream, a bounded number of bytes a
// step.
#pragma once
#include <stddef.h>
#include <stdint.h>

#include "core/maths.hpp"

namespace drivers {

enum class GpsFixType : uint8_t { none = 1, two_d = 2, three_d = 3 };

struct GpsFix {
    int32_t latitude_e7, longitude_e7;
    int32_t altitude_cm;         // above sea level
    core::Vector3 velocity_mps;  // north, east, down
    float ground_speed_mps;
    int32_t course_cd;     // 0..35999
    uint32_t time_ms;      // GPS time of week
    uint16_t week;         // GPS week; 0 when not told
    uint16_t hdop_c;       // the receiver's position dilution, 0.01
    uint16_t accuracy_cm;  // horizontal, the receiver's estimate
    uint16_t speed_accuracy_cms;
    GpsFixType type;
    uint8_t satellites;
};

class Ublox {
public:
    void start();
    // Every frame; reads at most kBytesPerStep bytes. True: fix() is new and whole: position and
    // velocity are of one epoch. Type may be `none`: then only type and satellites mean anything.
    bool step(uint32_t now_ms);

    const GpsFix& fix() const { return fix_; }
    bool healthy() const { return healthy_; }  // talks; says nothing about the fix
    uint16_t checksumErrors() const { return checksum_errors_; }
    uint16_t searches() const { return searches_; }  // baud rates tried so far

    static constexpr uint8_t kBytesPerStep = 48;  // 38400 baud bring 38 in 10 ms

private:
    enum class State : uint8_t { idle, greet, listen, run };
    static constexpr uint8_t kBuffer = 64;

    void tryNextBaud(uint32_t now_ms);
    void configure(uint32_t now_ms);
    void sendScript();
    void watch(uint32_t now_ms);
    bool feed(uint8_t byte);
    void keep(uint8_t byte);
    bool handle(uint32_t now_ms);
    bool part(uint8_t parts, uint32_t now_ms);
    void takePosition(const uint8_t* at);
    void takeVelocity(bool is_pvt);

    GpsFix fix_ = {};
    uint8_t payload_[kBuffer] = {};
    const uint8_t* script_ = nullptr;  // in flash, still to be sent
    uint32_t since_ms_ = 0;            // the state was entered or a message heard
    uint32_t whole_ms_ = 0;            // GPS time of the last whole epoch
    uint32_t stepped_ms_ = 0;          // an epoch came 200 ms after the one before
    uint32_t asked_ms_ = 0;            // the dynamic model was last asked for
    uint16_t length_ = 0, received_ = 0;
    uint16_t checksum_errors_ = 0, searches_ = 0;
    uint8_t class_ = 0, id_ = 0, sum_a_ = 0, sum_b_ = 0;
    uint8_t place_ = 0;  // in the frame being received
    uint8_t parts_ = 0;  // of the epoch fix_.time_ms seen so far
    uint8_t baud_index_ = 0;
    uint8_t script_left_ = 0;
    GpsFixType status_type_ = GpsFixType::none;
    State state_ = State::idle;
    bool healthy_ = false;
};

}  // namespace drivers
