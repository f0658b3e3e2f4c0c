// SPDX-License-Identifier: GPL-3.0-or-later
// Burr-Brown ADS7844, 12 bits (data sheet SBAS100), read by interrupts: a timer's begins a set of
// the channels, the bus's own takes it from one channel to the next, and what was read is summed up
// until somebody takes it. Nothing waits for the converter. Of its eight channels the fourth, the
// temperature of the gyros, is not asked for.
#pragma once
#include <stdint.h>
#include <string.h>

#include "core/rom.hpp"
#include "hal/interrupts.hpp"

namespace drivers {

struct Ads7844Sums {
    static constexpr uint8_t kChannels = 7;
    uint16_t sum[kChannels];   // of readings 0..4095
    uint8_t count[kChannels];  // which may differ by one: a set was under way
    uint8_t periods;           // over since the last time, the ones without readings too
    bool spoiled;              // there was an answer that the converter does not give
};

// Bus::begin(first, second) sends two bytes and has an interrupt at their end; Bus::received()
// fetches the two that came back, one by one; Bus::flush() forgets them.
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

    static uint8_t waiting() { return state_.periods; }
    // What has come since the last time. False: no whole set.
    static bool take(Ads7844Sums& to);

    // For an interrupt in assembler, which may do onSent() for exchanges before the last of a set.
    static constexpr uint8_t kLast = Ads7844Sums::kChannels;
    struct State;
    static State state_;
    static const uint8_t kAsk[];

private:
    static constexpr uint8_t kIdle = 0xFF;
    static constexpr uint8_t kMostSets = 15;  // and one under way: 16 * 4095 are 16 bits

    static uint8_t done() { return state_.next == kIdle || state_.next == 0 ? 0 : state_.next - 1; }
    static void pass() {
        if (state_.periods != 255) ++state_.periods;
    }
    static void add(uint16_t& sum, uint8_t high, uint8_t low);
};

template <class Bus, class Select>
struct Ads7844<Bus, Select>::State {
    uint16_t sum[Ads7844Sums::kChannels];
    uint8_t next = kIdle;  // the exchange under way: channel n is asked for, n - 1 ends
    uint8_t high = 0;
    uint8_t sets = 0, periods = 0;
    uint8_t ahead = 0;  // channels of the set under way when the sums were taken
    bool spoiled = false;
    constexpr State() : sum() {}
};

// S, the channel's address (single-ended: A0 comes first), SGL, always powered; table I.
template <class Bus, class Select>
const uint8_t Ads7844<Bus, Select>::kAsk[] ROM = {0x87, 0xC7, 0x97, 0xA7, 0xE7, 0xB7, 0xF7, 0};

template <class Bus, class Select>
typename Ads7844<Bus, Select>::State Ads7844<Bus, Select>::state_;

template <class Bus, class Select>
void Ads7844<Bus, Select>::beginSet() {
    if (state_.next != kIdle) {  // a set takes less than a tenth of the time between two
        state_.spoiled = true;
        pass();
        Select::high();
        Bus::flush();
        state_.next = kIdle;
        return;
    }
    if (state_.sets == kMostSets) return pass();  // nobody takes them
    Select::low();
    state_.next = 0;
    Bus::begin(core::romRead(kAsk[0]), 0);
}

// 16 clocks a conversion: the answer begins with the byte after the question, in its second bit,
// and ends in the byte of the next question (figure 5). Seven thousand times a second.
template <class Bus, class Select>
inline __attribute__((always_inline)) void Ads7844<Bus, Select>::onSent() {
    const uint8_t ended = state_.next;
    if (ended == kIdle) return;
    const uint8_t low = Bus::received();
    const uint8_t next_high = Bus::received();
    const uint8_t high = state_.high;
    if (ended != kLast) {
        const uint8_t next = ended + 1;
        Bus::begin(core::romRead(kAsk[next]), 0);
        state_.next = next;
        state_.high = next_high;
    } else {
        Select::high();
        state_.next = kIdle;
        ++state_.sets;
        pass();
    }
    if (ended != 0) add(state_.sum[static_cast<uint8_t>(ended - 1)], high, low);
}

// A zero, twelve bits, three zeros.
template <class Bus, class Select>
inline __attribute__((always_inline)) void Ads7844<Bus, Select>::add(uint16_t& sum, uint8_t high,
                                                                     uint8_t low) {
    if ((low & 0x07) | (high & 0x80)) state_.spoiled = true;
    sum += static_cast<uint16_t>(high * 32U) + static_cast<uint8_t>(low * 32U >> 8);
}

template <class Bus, class Select>
bool Ads7844<Bus, Select>::take(Ads7844Sums& to) {
    uint8_t sets, ahead, was_ahead;
    {
        const hal::Locked locked;
        sets = state_.sets;
        to.periods = state_.periods;
        to.spoiled = state_.spoiled;
        state_.periods = 0;
        state_.spoiled = false;
        if (sets == 0) return false;
        ahead = done();
        was_ahead = state_.ahead;
        state_.ahead = ahead;
        state_.sets = 0;
        memcpy(to.sum, state_.sum, sizeof(to.sum));
        memset(state_.sum, 0, sizeof(state_.sum));
    }
    for (uint8_t i = 0; i < Ads7844Sums::kChannels; ++i) {
        to.count[i] = static_cast<uint8_t>(sets + (i < ahead) - (i < was_ahead));
    }
    return true;
}

}  // namespace drivers
