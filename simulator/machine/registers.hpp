// SPDX-License-Identifier: GPL-3.0-or-later
// Data-space addresses and bits of the ATmega2560's registers that the machine touches
// (datasheet 2549, section 33 "Register Summary").
#pragma once
#include <cstdint>

namespace simulator {

constexpr uint32_t kClock_hz = 16000000;
constexpr uint64_t kCyclesPer_us = kClock_hz / 1000000;
constexpr uint32_t kFlashSize = 0x40000;
constexpr uint32_t kBootSection = 0x3E000;  // of 4096 words, as the boards are fused
constexpr uint16_t kRamEnd = 0x21FF;
constexpr uint16_t kEepromBytes = 4096;
constexpr uint8_t kSleepEnable = 1;    // in SMCR
constexpr uint8_t kWatchdogOn = 0x48;  // in WDTCSR: reset or interrupt

enum Register : uint16_t {
    kEifr = 0x3C,
    kGpior0 = 0x3E,
    kEecr = 0x3F,
    kEedr = 0x40,
    kEearl = 0x41,
    kEearh = 0x42,
    kPcifr = 0x3B,
    kGpior1 = 0x4A,
    kGpior2 = 0x4B,
    kSpcr = 0x4C,
    kSpsr = 0x4D,
    kSpdr = 0x4E,
    kSmcr = 0x53,
    kMcusr = 0x54,
    kRampz = 0x5B,
    kSpl = 0x5D,
    kSph = 0x5E,
    kWdtcsr = 0x60,
    kAdcl = 0x78,
    kAdch = 0x79,
    kAdcsra = 0x7A,
    kAdcsrb = 0x7B,
    kAdmux = 0x7C,
    kTwbr = 0xB8,
    kTwsr = 0xB9,
    kTwdr = 0xBB,
    kTwcr = 0xBC,
};

}  // namespace simulator
