// SPDX-License-Identifier: GPL-3.0-or-later
// The wiring of the native board: the roles firmware/ knows, joined to the device models of the
// World that the running NativeBoard hangs on. No pins: a chip select chooses a model.
#pragma once
#include <stdint.h>

#include "drivers/mpu6000.hpp"
#include "drivers/ms5611.hpp"

namespace board {

constexpr uint16_t kLoader_ms = 1165;

constexpr char kName[] = "APM 2 (native)";
constexpr uint8_t kModel = 2;

void start();

struct SensorBus {
    static uint8_t transfer(uint8_t mosi);
    static void begin(uint8_t mosi) { held = transfer(mosi); }
    static uint8_t end() { return held; }
    static uint8_t held;
    static void slow();
    static void fast();
    struct Lock {  // the data-ready interrupt waits until the last one is gone
        Lock();
        ~Lock();
        Lock(const Lock&) = delete;
        Lock& operator=(const Lock&) = delete;
    };
};

struct ImuSelect {
    static void low();
    static void high();
    static void output() {}
};

struct BarometerSelect {
    static void low();
    static void high();
    static void output() {}
};

using ProbeBus = SensorBus;
using ProbeSelect = ImuSelect;
using Inertial = drivers::Mpu6000<SensorBus, ImuSelect>;
using Barometer = drivers::Ms5611<SensorBus, BarometerSelect>;
constexpr bool kCompassUpsideDown = false;

struct FlashBus {
    static void send(const uint8_t* bytes, uint8_t size);
    static void receive(uint8_t* to, uint8_t size);
};

struct FlashSelect {
    static void low();
    static void high();
    static void output() {}
};

struct FlashReset {
    static void low();
    static void high();
    static void output() {}
};

struct Relay {
    static void low();
    static void high();
    static void output() {}
};

template <int number>
struct Led {
    static void on() {}
    static void off() {}
};
using LedA = Led<0>;
using LedB = Led<1>;
using LedC = Led<2>;

}  // namespace board
