// SPDX-License-Identifier: GPL-3.0-or-later
// The DataFlash's bus and pins: a chip may be put on it, without one it reads 0xFF.
#pragma once
#include <stdint.h>

#include <functional>
#include <vector>

namespace fakes {

struct FlashBus {
    // The chip: it is given the level of its pins, and asked for every byte.
    static inline std::function<void(bool low)> on_select, on_reset;
    static inline std::function<uint8_t(uint8_t out)> device;
    static inline std::vector<uint8_t> sent;  // since the select last fell
    static inline bool selected = false;
    static inline int clashes = 0;  // bytes that passed while it was high

    static void send(const uint8_t* bytes, uint8_t size) {
        for (; size > 0; --size) transfer(*bytes++);
    }
    static void receive(uint8_t* to, uint8_t size) {
        for (; size > 0; --size) *to++ = transfer(0);
    }
    static uint8_t transfer(uint8_t out) {
        clashes += !selected;
        sent.push_back(out);
        return device ? device(out) : 0xFF;
    }
    static void select(bool low) {
        if (low && !selected) sent.clear();
        selected = low;
        if (on_select) on_select(low);
    }
    static void reset() {
        on_select = on_reset = nullptr;
        device = nullptr;
        sent.clear();
        selected = false;
        clashes = 0;
    }
};

struct FlashSelect {
    static void output() {}
    static void low() { FlashBus::select(true); }
    static void high() { FlashBus::select(false); }
};

struct FlashReset {
    static void output() {}
    static void low() { level(true); }
    static void high() { level(false); }
    static void level(bool low) {
        if (FlashBus::on_reset) FlashBus::on_reset(low);
    }
};

}  // namespace fakes
