// SPDX-License-Identifier: GPL-3.0-or-later
// The drivers' bus with the simulator's chips on it, and time: every byte takes 2 us, the sensor
// makes its samples meanwhile, and its interrupt runs the driver as on the board: not inside a
// Bus::Lock, and once for each rise of the pin.
#pragma once
#include <cstdint>
#include <memory>
#include <random>

#include "drivers/mpu6000.hpp"
#include "drivers/ms5611.hpp"
#include "simulator/devices/mpu6000.hpp"
#include "simulator/devices/ms5611.hpp"
#include "simulator/world.hpp"

namespace model {

struct Bench {
    explicit Bench(simulator::SensorErrors errors = simulator::SensorErrors::none(),
                   uint8_t imu_product = simulator::Mpu6000::kRevisionD8)
        : imu(1, errors, imu_product), barometer(1, errors) {
        truth.force_z_mss = -9.80665;
        current = this;
    }
    ~Bench() { current = nullptr; }

    static inline Bench* current = nullptr;

    simulator::Truth truth{};
    simulator::Mpu6000 imu;
    simulator::Ms5611 barometer;
    uint64_t now_us = 0;
    bool imu_unplugged = false, barometer_unplugged = false;
    uint8_t floating = 0;  // what a bus without a chip reads
    double noise = 0;      // share of the bytes read that have a wrong bit
    std::mt19937 random{1};
    int locks = 0;
    bool pin = false, pending = false, in_interrupt = false;
    bool lose_next_edge = false;
    void (*interrupt)() = nullptr;

    void advance_us(uint64_t by_us) {
        const uint64_t end_us = now_us + by_us;
        while (imu.nextSample_us() <= end_us) {
            now_us = std::max(now_us, imu.nextSample_us());
            truth.time_us = now_us;
            imu.sample(truth, now_us);
            look();
        }
        now_us = std::max(now_us, end_us);
        look();
    }
    void look() {
        const bool level = imu.interruptPin() && !imu_unplugged;
        if (level && !pin) {
            pending = !lose_next_edge;
            lose_next_edge = false;
        }
        pin = level;
        serve();
    }
    void serve() {
        if (!pending || locks > 0 || in_interrupt || !interrupt) return;
        pending = false;
        in_interrupt = true;
        interrupt();
        in_interrupt = false;
    }
};

struct Bus {
    static inline int chosen = -1;
    static inline bool is_fast = false;
    static inline int too_fast = 0;  // bytes to a register of the MPU-6000 at more than 1 MHz
    static void slow() { is_fast = false; }
    static void fast() { is_fast = true; }
    static uint8_t transfer(uint8_t out) {
        Bench& b = *Bench::current;
        uint8_t in = b.floating;
        if (chosen == 0 && !b.imu_unplugged) in = b.imu.transfer(out, b.now_us);
        if (chosen == 1 && !b.barometer_unplugged) in = b.barometer.transfer(out, b.now_us);
        b.advance_us(2);
        if (std::uniform_real_distribution<>()(b.random) < b.noise) in ^= 1 << b.random() % 8;
        return in;
    }
    static inline uint8_t held = 0;
    static void begin(uint8_t out) { held = transfer(out); }
    static uint8_t end() { return held; }
    struct Lock {
        Lock() { ++Bench::current->locks; }
        ~Lock() {
            --Bench::current->locks;
            Bench::current->serve();
        }
    };
};

template <int number>
struct Select {
    static void output() {}
    static void low() { choose(true); }
    static void high() { choose(false); }
    static void choose(bool chosen) {
        Bench& b = *Bench::current;
        Bus::chosen = chosen ? number : -1;
        if (number == 0) b.imu.select(chosen, b.now_us);
        if (number == 1) b.barometer.select(chosen, b.now_us);
    }
};

using Imu = drivers::Mpu6000<Bus, Select<0>>;
using Barometer = drivers::Ms5611<Bus, Select<1>>;

}  // namespace model
