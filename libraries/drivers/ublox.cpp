// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/ublox.hpp"

#include <string.h>

#include "core/rom.hpp"
#include "drivers/ublox_script.hpp"
#include "hal/serial.hpp"

namespace drivers {
namespace {

constexpr UbloxScript kGreeting ROM = ubloxGreeting();
constexpr UbloxScript kConfiguration ROM = ubloxConfiguration();
constexpr UbloxScript kQuestion ROM = ubloxQuestion();
constexpr uint8_t kGreetingSize = ubloxGreeting().size;
constexpr uint8_t kConfigurationSize = ubloxConfiguration().size;
constexpr uint8_t kQuestionSize = ubloxQuestion().size;

constexpr uint32_t kBaud = 38400;
constexpr uint32_t kBauds[] ROM = {38400, 9600, 57600, 115200, 4800, 19200};

constexpr uint16_t kGreet_ms = 160;    // 63 bytes at 4800 baud are 131 ms on the line
constexpr uint16_t kListen_ms = 1200;  // a receiver as delivered has one epoch a second
constexpr uint16_t kSilent_ms = 1200;
constexpr uint16_t kWrongRate_ms = 3000;
constexpr uint16_t kQuestion_ms = 20000;
constexpr uint16_t kEpoch_ms = 200;
constexpr uint16_t kLongestPayload = 512;  // more is noise that looked like a header

constexpr uint8_t kHasPosition = 1, kHasVelocity = 2, kReported = 4;
constexpr uint8_t kNav = 0x01, kCfg = 0x06;
constexpr uint8_t kPosllh = 0x02, kStatus = 0x03, kSol = 0x06, kPvt = 0x07, kVelned = 0x12;
constexpr uint8_t kCfgNav5 = 0x24;

template <class T>
T load(const uint8_t* at) {  // this chip and the receiver are both little-endian
    T value;
    memcpy(&value, at, sizeof value);
    return value;
}
uint16_t saturated(uint32_t value) { return value > UINT16_MAX ? UINT16_MAX : value; }

GpsFixType fixType(uint8_t receiver_type, uint8_t flags) {
    if (!(flags & 0x01)) return GpsFixType::none;
    if (receiver_type == 2) return GpsFixType::two_d;
    return receiver_type == 3 || receiver_type == 4 ? GpsFixType::three_d : GpsFixType::none;
}

bool plausible(const GpsFix& fix) {
    constexpr float kFastest_mps = 300;
    return fix.latitude_e7 >= -900000000 && fix.latitude_e7 <= 900000000 &&
           fix.longitude_e7 >= -1800000000 && fix.longitude_e7 <= 1800000000 &&
           fix.ground_speed_mps < kFastest_mps && fabsf(fix.velocity_mps.z) < kFastest_mps;
}

}  // namespace

void Ublox::start() { *this = Ublox(); }

void Ublox::tryNextBaud(uint32_t now_ms) {
    healthy_ = false;
    if (++searches_ == 0) searches_ = UINT16_MAX;
    hal::serialOpen(hal::Port::gps, core::romRead(kBauds[baud_index_]));
    if (++baud_index_ == core::count(kBauds)) baud_index_ = 0;
    script_ = kGreeting.bytes;
    script_left_ = kGreetingSize;
    place_ = 0;
    since_ms_ = now_ms;
    state_ = State::greet;
}

void Ublox::configure(uint32_t now_ms) {
    script_ = kConfiguration.bytes;
    script_left_ = kConfigurationSize;
    stepped_ms_ = asked_ms_ = now_ms;
}

void Ublox::sendScript() {
    uint8_t part[16];
    uint8_t size = script_left_ < sizeof part ? script_left_ : sizeof part;
    const uint8_t room = hal::serialRoom(hal::Port::gps);
    if (size > room) size = room;
    if (size == 0) return;
    ROM_COPY(part, script_, size);
    if (!hal::serialWrite(hal::Port::gps, part, size)) return;
    script_ += size;
    script_left_ = static_cast<uint8_t>(script_left_ - size);
}

bool Ublox::step(uint32_t now_ms) {
    if (state_ == State::idle) tryNextBaud(now_ms);
    const bool sending = script_left_ > 0;
    if (sending) sendScript();
    if (state_ == State::greet) {
        if (sending) since_ms_ = now_ms;
        if (now_ms - since_ms_ < kGreet_ms) return false;
        hal::serialOpen(hal::Port::gps, kBaud);
        configure(now_ms);
        since_ms_ = now_ms;
        state_ = State::listen;
    }
    for (uint8_t n = 0, byte; n < kBytesPerStep && hal::serialRead(hal::Port::gps, byte); ++n) {
        if (feed(byte) && handle(now_ms)) return true;
    }
    if (state_ == State::listen && now_ms - since_ms_ > kListen_ms) tryNextBaud(now_ms);
    if (state_ == State::run) watch(now_ms);
    return false;
}

void Ublox::watch(uint32_t now_ms) {
    if (now_ms - since_ms_ > kSilent_ms) {
        baud_index_ = 0;
        return tryNextBaud(now_ms);
    }
    if (script_left_ > 0) return;
    if (now_ms - stepped_ms_ > kWrongRate_ms) return configure(now_ms);
    if (now_ms - asked_ms_ > kQuestion_ms) {
        asked_ms_ = now_ms;
        script_ = kQuestion.bytes;
        script_left_ = kQuestionSize;
    }
}

// True: a whole message with a good checksum stands in payload_.
bool Ublox::feed(uint8_t byte) {
    if (place_ >= 2 && place_ <= 6) {
        sum_a_ = static_cast<uint8_t>(sum_a_ + byte);
        sum_b_ = static_cast<uint8_t>(sum_b_ + sum_a_);
    }
    switch (place_) {
        case 0:
            place_ = byte == 0xB5;
            return false;
        case 1:
            place_ = byte == 0x62 ? 2 : byte == 0xB5;
            sum_a_ = sum_b_ = 0;
            return false;
        case 2:
            class_ = byte;
            break;
        case 3:
            id_ = byte;
            break;
        case 4:
            length_ = byte;
            break;
        case 5:
            length_ |= static_cast<uint16_t>(byte) << 8;
            received_ = 0;
            place_ = length_ > kLongestPayload ? 0 : length_ == 0 ? 7 : 6;
            return false;
        case 6:
            keep(byte);
            if (++received_ < length_) return false;
            break;
        case 7:
            if (byte == sum_a_) break;
            ++checksum_errors_;
            place_ = byte == 0xB5;
            return false;
        default:
            place_ = 0;
            if (byte == sum_b_) return true;
            ++checksum_errors_;
            return false;
    }
    ++place_;
    return false;
}

// NAV-PVT is longer than the buffer, but bytes 4..19 (the calendar) and the end are of no use here.
void Ublox::keep(uint8_t byte) {
    uint16_t at = received_;
    if (class_ == kNav && id_ == kPvt && at >= 4) {
        if (at < 20) return;
        at -= 16;
    }
    if (at < kBuffer) payload_[at] = byte;
}

bool Ublox::handle(uint32_t now_ms) {
    since_ms_ = now_ms;
    state_ = State::run;
    healthy_ = true;
    if (class_ == kCfg && id_ == kCfgNav5 && length_ == 36) {
        if (payload_[2] != kUbloxAirborne4g) configure(now_ms);
        return false;
    }
    if (class_ != kNav) return false;
    if (id_ == kStatus && length_ == 16) {
        status_type_ = fixType(payload_[4], payload_[5]);
    } else if (id_ == kSol && length_ == 52) {
        fix_.week = load<uint16_t>(payload_ + 8);
        status_type_ = fixType(payload_[10], payload_[11]);
        fix_.hdop_c = load<uint16_t>(payload_ + 44);
        fix_.satellites = payload_[47];
    } else if (id_ == kPosllh && length_ == 28) {
        return part(kHasPosition, now_ms);
    } else if (id_ == kVelned && length_ == 36) {
        return part(kHasVelocity, now_ms);
    } else if (id_ == kPvt && length_ >= 84) {
        return part(kHasPosition | kHasVelocity, now_ms);
    }
    return false;
}

// One of the messages that make an epoch; true when the epoch is whole for the first time.
bool Ublox::part(uint8_t parts, uint32_t now_ms) {
    const uint32_t time_ms = load<uint32_t>(payload_);
    if (time_ms != fix_.time_ms || parts_ == 0) {
        fix_.time_ms = time_ms;
        parts_ = 0;
    }
    if (parts_ & kReported) return false;
    parts_ |= parts;
    const bool is_pvt = parts == (kHasPosition | kHasVelocity);
    if (is_pvt) {
        status_type_ = fixType(payload_[4], payload_[5]);
        fix_.satellites = payload_[7];
        fix_.hdop_c = load<uint16_t>(payload_ + 60);
    }
    if (parts & kHasPosition) takePosition(payload_ + (is_pvt ? 8 : 4));
    if (parts & kHasVelocity) takeVelocity(is_pvt);
    if (parts_ != (kHasPosition | kHasVelocity)) return false;
    parts_ |= kReported;
    // a receiver that missed one of the messages of its configuration never makes a whole epoch
    if (time_ms - whole_ms_ == kEpoch_ms) stepped_ms_ = now_ms;
    whole_ms_ = time_ms;
    fix_.type = plausible(fix_) ? status_type_ : GpsFixType::none;
    return true;
}

// Longitude, latitude, height over the ellipsoid and over the sea, accuracy: in POSLLH as in PVT.
void Ublox::takePosition(const uint8_t* at) {
    fix_.longitude_e7 = load<int32_t>(at);
    fix_.latitude_e7 = load<int32_t>(at + 4);
    fix_.altitude_cm = load<int32_t>(at + 12) / 10;
    fix_.accuracy_cm = saturated(load<uint32_t>(at + 16) / 10);
}

// VELNED has cm/s and a 3D speed before the one over ground; PVT has mm/s.
void Ublox::takeVelocity(bool is_pvt) {
    const uint8_t* velocity = payload_ + (is_pvt ? 32 : 4);
    const uint8_t* ground = payload_ + (is_pvt ? 44 : 20);
    const float scale = is_pvt ? 0.001f : 0.01f;
    fix_.velocity_mps = {load<int32_t>(velocity) * scale, load<int32_t>(velocity + 4) * scale,
                         load<int32_t>(velocity + 8) * scale};
    fix_.ground_speed_mps = load<int32_t>(ground) * scale;
    fix_.course_cd = core::wrap360_cd(load<int32_t>(ground + 4) / 1000 % 36000);
    const uint32_t accuracy = load<uint32_t>(ground + 8);
    fix_.speed_accuracy_cms = saturated(is_pvt ? accuracy / 10 : accuracy);
}

}  // namespace drivers
