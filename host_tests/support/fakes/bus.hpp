// SPDX-License-Identifier: GPL-3.0-or-later
// An SPI bus that plays a script or asks a device model, and pins that remember what was done to
// them. What passed is recorded as transactions: one from the fall of a pin to its rise.
#pragma once
#include <stdint.h>

#include <deque>
#include <functional>
#include <initializer_list>
#include <vector>

namespace fakes {

struct Transaction {
    int pin;  // which Pin was low
    std::vector<uint8_t> sent;
    bool fast;    // the bus's rate at the last byte
    bool locked;  // all its bytes passed under a Bus::Lock
};

struct Bus {
    static uint8_t transfer(uint8_t out);
    static void begin(uint8_t out) { held = transfer(out); }
    static uint8_t end() { return held; }
    static inline uint8_t held = 0;
    static void slow() { is_fast = false; }
    static void fast() { is_fast = true; }

    struct Lock {
        Lock() {
            ++locks;
            ++locks_taken;
        }
        ~Lock() { --locks; }
        Lock(const Lock&) = delete;
        Lock& operator=(const Lock&) = delete;
    };

    // What the next bytes will be answered with; 0 when the script is at its end.
    static void reply(std::initializer_list<uint8_t> bytes);
    static std::deque<uint8_t> replies;
    // Instead of the script: asked for every byte, with the pin that is low (-1: none).
    static std::function<uint8_t(int pin, uint8_t out)> device;

    static std::vector<Transaction> transactions;
    static bool is_fast;
    static int locks, locks_taken;
    static int selected;  // the pin that is low, -1 when none
    static int clashes;   // times a second pin fell while one was low, or a byte met no pin

    static void select(int pin);
    static void release(int pin);
    static void reset();
};

template <int number>
struct Pin {
    static void output() { is_output = true; }
    static void high() {
        if (!level) Bus::release(number);
        level = true;
    }
    static void low() {
        if (level) Bus::select(number);
        level = false;
    }
    static inline bool level = true;
    static inline bool is_output = false;
};

// A line that is switched and selects nothing: relay, LED.
template <int number>
struct Switch {
    static void output() { is_output = true; }
    static void high() { level = true; }
    static void low() { level = false; }
    static void on() { lit = true; }
    static void off() { lit = false; }
    static inline bool level = false, is_output = false, lit = false;
};

}  // namespace fakes
