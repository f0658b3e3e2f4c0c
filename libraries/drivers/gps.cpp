// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivers/gps.hpp"

#include "core/rom.hpp"
#include "drivers/gps_script.hpp"
#include "drivers/mtk.hpp"
#include "drivers/nmea.hpp"
#include "drivers/ublox.hpp"
#include "hal/serial.hpp"

namespace drivers {
namespace {

template <uint8_t size>
struct Exactly {
    uint8_t of[size];
    constexpr explicit Exactly(const GpsScript& script) : of() {
        for (uint8_t i = 0; i < size; ++i) of[i] = script.bytes[i];
    }
};
constexpr Exactly<ubloxValues().size> kUbloxValues ROM(ubloxValues());
constexpr Exactly<ubloxGreeting().size> kUbloxGreeting ROM(ubloxGreeting());
constexpr Exactly<ubloxConfiguration().size> kUbloxConfiguration ROM(ubloxConfiguration());
constexpr Exactly<ubloxQuestion().size> kUbloxQuestion ROM(ubloxQuestion());
constexpr Exactly<mtkConfiguration().size> kMtkConfiguration ROM(mtkConfiguration());
constexpr uint8_t kMtkGreetingSize = mtkGreeting().size;

struct Script {
    const uint8_t* bytes;
    uint8_t size;
};
// Sent in this order: a greeting that is obeyed changes the rate, and the rest is not understood.
constexpr Script kScripts[] ROM = {
    {kUbloxValues.of, sizeof kUbloxValues},
    {kUbloxGreeting.of, sizeof kUbloxGreeting},
    {kMtkConfiguration.of, kMtkGreetingSize},
    {kUbloxConfiguration.of, sizeof kUbloxConfiguration},
    {kUbloxQuestion.of, sizeof kUbloxQuestion},
    {kMtkConfiguration.of, sizeof kMtkConfiguration},
};
constexpr uint8_t kSetUblox = 1, kGreetUblox = kSetUblox | 2, kGreetMtk = 4,
                  kConfigureUblox = kSetUblox | 8, kAskUblox = 16, kConfigureMtk = 32;

// The rate a receiver is set to, and then those it may have at first, the usual ones first.
constexpr uint32_t kBauds[] ROM = {38400, 9600, 57600, 115200, 4800, 19200};

struct Receiver {
    bool (*read)(const uint8_t* message, GpsEpoch& epoch);
    uint16_t latency_ms;  // from the moment it measures to the first byte
    uint16_t silent_ms;   // after this it has fallen silent
    uint8_t greeting, configuration, question;
};
// clang-format off
constexpr Receiver kReceivers[] ROM = {
    //           latency silent  greeting     configuration    question
    {readUblox,  200,    1200,   kGreetUblox, kConfigureUblox, kAskUblox},
    {readMtk16,  200,    1200,   kGreetMtk,   kConfigureMtk,   0},
    {readMtk19,  200,    1200,   kGreetMtk,   kConfigureMtk,   0},
    {readNmea,   200,    2500,   0,           0,               0},  // may send once a second
};
// clang-format on
static_assert(gps_nmea == gps_ublox + core::count(kReceivers) - 1, "GPS_TYPE names a row");

Receiver receiver(GpsProtocol protocol) {
    return core::romRead(kReceivers[static_cast<uint8_t>(protocol) - 1]);
}

constexpr uint8_t kAnswer_ms = 30;     // an order is obeyed and its answer on the way
constexpr uint16_t kCall_ms = 300;     // who has just been set to five fixes a second has sent one
constexpr uint16_t kListen_ms = 1100;  // a receiver as delivered talks once a second
constexpr uint16_t kWrongRate_ms = 3000;
constexpr uint16_t kQuestion_ms = 20000;
constexpr uint16_t kGreetAgain_ms = 2000;
constexpr uint8_t kGreetings = 2;
constexpr uint16_t kEpoch_ms = 200;
constexpr uint16_t kLongestBurst_ms = 500;

// What goes into the port's buffer at once; also what is still in it when all was given to it.
constexpr uint8_t kAtOnce = 30;

}  // namespace

void Gps::start(uint8_t type) {
    type_ = type;
    found_ = GpsProtocol::none;
    round_ = 0;
    state_ = State::idle;
}

uint32_t Gps::baud() const { return core::romRead(kBauds[state_ == State::call ? 0 : round_]); }

uint16_t Gps::refused() const {
    const uint32_t both = uint32_t{framing_.refused()} + epoch_.refused;
    return both > UINT16_MAX ? UINT16_MAX : static_cast<uint16_t>(both);
}

void Gps::queue(uint8_t scripts) { waiting_ |= scripts; }

void Gps::send() {
    if (script_left_ == 0) {
        if (waiting_ == 0) return;
        uint8_t next = 0;
        while (!(waiting_ >> next & 1)) ++next;
        waiting_ &= static_cast<uint8_t>(waiting_ - 1);
        const Script script = core::romRead(kScripts[next]);
        script_ = script.bytes;
        script_left_ = script.size;
    }
    uint8_t part[kAtOnce];
    uint8_t size = script_left_ < sizeof part ? script_left_ : sizeof part;
    const uint8_t room = hal::serialRoom(hal::Port::gps);
    if (size > room) size = room;
    if (size == 0) return;
    ROM_COPY(part, script_, size);
    if (!hal::serialWrite(hal::Port::gps, part, size)) return;
    script_ += size;
    script_left_ = static_cast<uint8_t>(script_left_ - size);
}

// ---- the search: greet at a rate, call at the one greeted receivers now have, listen at the first

void Gps::greet(uint16_t now) {
    found_ = candidate_ = GpsProtocol::none;
    script_left_ = waiting_ = 0;
    state_ = State::greet;
    since_ = now;
    if (type_ == gps_any) {
        queue(kGreetUblox | kGreetMtk);
    } else {
        queue(receiver(static_cast<GpsProtocol>(type_ - 1)).greeting);
    }
    hal::serialOpen(hal::Port::gps, baud());
    framing_.clear();
}

void Gps::call(uint16_t now) {
    state_ = State::call;
    since_ = now;
    if (round_ != 0) hal::serialOpen(hal::Port::gps, baud());
    framing_.clear();
    if (type_ <= gps_ublox) queue(kConfigureUblox);
}

void Gps::listen(uint16_t now) {
    state_ = State::listen;
    since_ = now;
    if (round_ == 0) return;
    hal::serialOpen(hal::Port::gps, baud());
    framing_.clear();
    script_left_ = waiting_ = 0;
}

void Gps::goOn(uint16_t now) {
    const uint16_t passed = now - since_;
    if (state_ == State::greet) {
        if (type_ == gps_nmea) return listen(now);
        if (!configured()) since_ = now;
        // ten bits a byte
        else if (passed > kAnswer_ms + kAtOnce * 10000UL / baud())
            call(now);
    } else if (state_ == State::call) {
        if (passed > kCall_ms) listen(now);
    } else if (state_ == State::listen) {
        if (passed <= kListen_ms) return;
        if (++round_ == core::count(kBauds)) round_ = 0;
        greet(now);
    } else {
        watch(now);
    }
}

// Whether a message may be one of a receiver yet to be found.
bool Gps::counts(GpsProtocol protocol) const {
    if (type_ != gps_any && type_ - 1 != static_cast<uint8_t>(protocol)) return false;
    if (state_ == State::greet) return false;
    if (protocol == GpsProtocol::ublox) return isOfUblox(framing_.message());
    if (protocol != GpsProtocol::nmea)
        return found_ <= GpsProtocol::none || found_ == GpsProtocol::nmea;
    // At the call's rate it may still be on its way to another protocol.
    return found_ == GpsProtocol::none && isOfNmea(framing_.message()) &&
           !(state_ == State::call && round_ == 0);
}

void Gps::adopt(GpsProtocol protocol, uint16_t now) {
    const Receiver now_is = receiver(protocol);
    if (state_ == State::call) round_ = 0;
    // in a call, and after one, a u-blox has its configuration
    if (round_ != 0 || protocol != GpsProtocol::ublox) queue(now_is.configuration);
    state_ = State::run;
    found_ = protocol;
    stepped_ = asked_ = now;
    greetings_ = type_ == gps_any && protocol == GpsProtocol::nmea ? kGreetings : 0;
    epoch_.parts = 0;
    epoch_.type = epoch_.fix.type = GpsFixType::unknown;
    epoch_.forgot = epoch_.odd = false;
}

// ---- what was found

void Gps::watch(uint16_t now) {
    const Receiver& is = kReceivers[static_cast<uint8_t>(found_) - 1];
    if (static_cast<uint16_t>(now - since_) > core::romRead(is.silent_ms)) return greet(now);
    if (!configured()) return;
    if (greetings_ > 0 && static_cast<uint16_t>(now - asked_) > kGreetAgain_ms) {
        --greetings_;
        asked_ = now;
        return queue(kGreetUblox | kGreetMtk);
    }
    if (epoch_.forgot || static_cast<uint16_t>(now - stepped_) > kWrongRate_ms) {
        epoch_.forgot = false;
        stepped_ = asked_ = now;
        queue(core::romRead(is.configuration));
    } else if (static_cast<uint16_t>(now - asked_) > kQuestion_ms) {
        asked_ = now;
        queue(core::romRead(is.question));
    }
}

// Two messages of a kind find a receiver: one may be chance.
// Never inlined: in a larger function stack_bound.mjs loses track of the pointer it calls through.
__attribute__((noinline)) bool Gps::heard(GpsProtocol protocol, uint16_t now) {
    if (protocol != found_) {
        if (!counts(protocol)) return false;
        if (state_ != State::run) since_ = now;
        if (candidate_ != protocol) {
            candidate_ = protocol;
            return false;
        }
        adopt(protocol, now);
    }
    since_ = now;
    const Receiver& is = kReceivers[static_cast<uint8_t>(protocol) - 1];
    const uint32_t before = epoch_.fix.time_ms;
    if (!core::romRead(is.read)(framing_.message(), epoch_)) return false;
    if (epoch_.fix.time_ms - before == kEpoch_ms) stepped_ = now;
    // it may have been switched on just now, and could do better
    if (protocol == GpsProtocol::nmea && type_ == gps_any && epoch_.fix.type == GpsFixType::none &&
        greetings_ == 0)
        greetings_ = 1;
    const uint32_t line_ms = burst_ * 10000UL / baud();
    epoch_.fix.age_ms =
        core::romRead(is.latency_ms) +
        static_cast<uint16_t>(line_ms > kLongestBurst_ms ? kLongestBurst_ms : line_ms);
    return true;
}

bool Gps::step(uint32_t now_ms) {
    if (type_ == gps_none || type_ > gps_nmea) return false;
    const uint16_t now = static_cast<uint16_t>(now_ms);
    if (state_ == State::idle) greet(now);
    send();
    goOn(now);
    if (hal::serialAvailable(hal::Port::gps) == 0) burst_ = 0;
    bool whole = false;
    for (uint8_t n = 0, byte; !whole && n < kBytesPerStep && hal::serialRead(hal::Port::gps, byte);
         ++n) {
        ++burst_;
        for (GpsProtocol protocol = framing_.put(byte); protocol != GpsProtocol::none;
             protocol = framing_.next())
            whole = heard(protocol, now) || whole;
    }
    return whole;
}

}  // namespace drivers
