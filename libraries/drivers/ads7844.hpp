// SPDX-License-Identifier: GPL-3.0-or-later
// Burr-Brown ADS7844, 12 bits (data sheet SBAS100), read by interrupts: a timer's begins a set of
// channels, the bus's own takes it from one to the next, and what was read is summed up until
// somebody takes it. Nothing waits for the converter. A set is the six inertial channels; every
// fourth has the airspeed before them. The temperature of the gyros is not asked for.
#pragma once
#include <stdint.h>
#include <string.h>

#include "core/rom.hpp"
#include "hal/interrupts.hpp"

namespace drivers {

struct Ads7844Sums {
    // in the order in which their answers are complete
    enum Channel : uint8_t {
        force_y,
        rate_z,
        rate_y,
        force_x,
        force_z,
        rate_x,
        airspeed,
        kChannels
    };
    uint16_t sum[kChannels];   // of readings 0..4095
    uint8_t count[kChannels];  // which may differ by one: a set was under way
    uint8_t periods;           // over since the last time, the ones without readings too
    bool invalid;              // there was an answer that the converter does not give
};

// Bus::begin(first, second) sends two bytes; Bus::ended() says whether they have gone out, of which
// there is an interrupt between Bus::wake() and Bus::rest(). Bus::received() fetches the two that
// came back, one by one; Bus::flush() forgets them.
template <class Bus, class Select>
class Ads7844 {
public:
    static void start() {
        Select::high();
        Select::output();
    }
    // From a timer's interrupt, at equal times.
    static void beginSet();
    // From the bus's interrupt.
    static void onSent();

    static uint8_t waiting() {
        const uint8_t all = sets() + state_.missed;
        return all < state_.missed ? 255 : all;
    }
    // What has come since the last time. False: no whole set.
    static bool take(Ads7844Sums& to);

    // S, the channel's address (single-ended: A0 comes first, table I) and a bit that does not
    // matter, all so low that the answer ends with a byte; SGL and always powered come with the
    // next. What was asked last is known by kAsk + 2 * address, which counts up from set to end.
    static constexpr uint8_t kAsk = 0x10, kRest = 0xE0;
    static constexpr uint8_t kGap = kAsk + 2 * 5;       // the temperature
    static constexpr uint8_t kLast = kAsk + 2 * 6;      // asked for at the end of each set
    static constexpr uint8_t kAirspeed = kAsk + 2 * 7;  // and this before some
    static constexpr uint8_t kAfterAirspeed = kAsk + 0x20;
    static constexpr uint8_t kIdle = 0;

    static constexpr uint8_t kFull = 15;  // sets; and one under way: 16 * 4095 are 16 bits
    static constexpr uint8_t kAirspeedEvery = 4;

    // For interrupts in assembler, which may do what comes most often.
    struct State;
    static constexpr uint8_t kStateAlignment = 32;
    static State state_;

private:
    // in the place of `sets`
    static constexpr uint8_t kAgain = 0xFE;  // to begin anew
    static constexpr uint8_t kFirst = 0xFF;  // under way, and its readings do not count

    static uint8_t sets() { return state_.sets > kFull ? 0 : state_.sets; }
    static uint8_t done();
    static void miss() {
        if (state_.missed != 255) ++state_.missed;
    }
    static void ask(uint8_t what);
    static void begin(uint8_t what);
    static void stop();
    static void add(uint8_t channel, uint8_t low);
    static void copySums(Ads7844Sums& to);
};

template <class Bus, class Select>
struct Ads7844<Bus, Select>::State {
    uint16_t sum[Ads7844Sums::kChannels];
    uint8_t asked = kIdle;
    uint8_t high = 0;  // of the answer whose end comes with the next two bytes
    uint8_t sets = 0, airspeeds = 0;
    uint8_t missed = 0;  // periods without a set
    uint8_t ahead = 0;   // channels of the set under way when the sums were taken
    bool invalid = false;
    constexpr State() : sum() {}
};

// Aligned, so that its addresses differ in their lower bytes alone: apm1/converter.cpp counts on
// it.
template <class Bus, class Select>
typename Ads7844<Bus, Select>::State Ads7844<Bus, Select>::state_
    __attribute__((aligned(Ads7844<Bus, Select>::kStateAlignment)));

template <class Bus, class Select>
inline __attribute__((always_inline)) void Ads7844<Bus, Select>::ask(uint8_t what) {
    Bus::begin(what & 0x1F, kRest);
    state_.asked = what;
}

template <class Bus, class Select>
inline __attribute__((always_inline)) void Ads7844<Bus, Select>::begin(uint8_t what) {
    Bus::wake();
    ask(what);
}

template <class Bus, class Select>
inline __attribute__((always_inline)) void Ads7844<Bus, Select>::stop() {
    Bus::rest();
    Select::high();
    state_.asked = kIdle;
}

// Four zeros, twelve bits.
template <class Bus, class Select>
inline __attribute__((always_inline)) void Ads7844<Bus, Select>::add(uint8_t channel, uint8_t low) {
    const uint8_t high = state_.high;
    if (high & 0xF0) state_.invalid = true;
    state_.sum[channel] += static_cast<uint16_t>(high << 8 | low);
}

// The last two answers of a set stay in the bus's receiver and in the converter until the next
// begins, which is soon enough for it: 1.6 ms a conversion, data sheet. A set takes less than a
// tenth of that, so one that has not ended never will.
template <class Bus, class Select>
void Ads7844<Bus, Select>::beginSet() {
    if (state_.asked == kIdle) {
        miss();
        if (state_.sets == kFull) return;  // nobody takes them
        Bus::flush();
        Select::low();
        state_.high = 0;
        state_.sets = kFirst;
        return begin(kAsk);
    }
    const bool ended = state_.asked == kLast && Bus::ended();
    if (!ended || state_.sets == kAgain) {
        if (!ended) state_.invalid = true;
        if (state_.sets > kFull) state_.sets = 0;
        miss();
        return stop();
    }
    add(Ads7844Sums::rate_x, Bus::received());
    state_.high = Bus::received();
    if (state_.sets == kFirst) {
        miss();
        memset(state_.sum, 0, sizeof(state_.sum));
        state_.sets = state_.airspeeds = state_.ahead = 0;
    } else if (++state_.sets == kFull) {
        return stop();
    }
    begin(state_.sets % kAirspeedEvery == 0 ? kAirspeed : kAsk);
}

// 16 clocks a conversion: the first byte that came back ends the answer to the question before the
// last, the second begins that to the last (figure 4).
template <class Bus, class Select>
inline __attribute__((always_inline)) void Ads7844<Bus, Select>::onSent() {
    if (state_.asked == kIdle) return;
    const uint8_t low = Bus::received();
    uint8_t next = state_.asked + 2, channel = (next - kAsk) / 2 - 1;
    if (next == kGap) {
        next = kLast;
    } else if (next == kAirspeed + 2) {
        next = kAfterAirspeed;
        channel = Ads7844Sums::force_y;
    } else if (next == kAfterAirspeed + 2) {
        next = kAsk + 2;
        channel = Ads7844Sums::airspeed;
        ++state_.airspeeds;
    }
    ask(next);
    if (next == kLast) Bus::rest();
    add(channel, low);
    state_.high = Bus::received();
}

// Of the channels, in their order, that the set under way has read.
template <class Bus, class Select>
uint8_t Ads7844<Bus, Select>::done() {
    switch (state_.asked) {
        case kIdle:
        case kAirspeed:
            return 0;
        case kAfterAirspeed:
            return 1;
        case kLast:
            return 5;
        default:
            return (state_.asked - kAsk) / 2;
    }
}

template <class Bus, class Select>
void Ads7844<Bus, Select>::copySums(Ads7844Sums& to) {
    for (uint8_t i = 0; i < Ads7844Sums::kChannels; ++i) {
        to.sum[i] = state_.sum[i];
        state_.sum[i] = 0;
    }
    to.count[Ads7844Sums::airspeed] = state_.airspeeds;
    state_.airspeeds = 0;
    state_.sets = 0;
}

template <class Bus, class Select>
bool Ads7844<Bus, Select>::take(Ads7844Sums& to) {
    uint8_t whole, ahead, was_ahead;
    {
        const hal::Locked locked;
        whole = sets();
        to.periods = waiting();
        to.invalid = state_.invalid;
        state_.missed = 0;
        state_.invalid = false;
        if (whole == 0) return false;
        ahead = done();
        was_ahead = state_.ahead;
        state_.ahead = ahead;
        copySums(to);
        if (to.invalid) state_.sets = kAgain;
    }
    for (uint8_t i = 0; i < Ads7844Sums::airspeed; ++i) {
        to.count[i] = static_cast<uint8_t>(whole + (i < ahead) - (i < was_ahead));
    }
    return true;
}

}  // namespace drivers
