// SPDX-License-Identifier: GPL-3.0-or-later
// Tables that stay in flash. On AVR a const object is copied to RAM at start-up unless it is
// marked and read through the program-memory bus; on the host both words mean nothing. This
// header, multiply.hpp, convert.hpp, crc.hpp and crypto/rounds.hpp are all in libraries/ that knows
// the difference.
#pragma once
#include <stddef.h>
#include <stdint.h>

#ifdef __AVR__
#include <avr/pgmspace.h>
#define ROM PROGMEM
#define ROM_COPY memcpy_P
#else
#include <string.h>
#define ROM
#define ROM_COPY memcpy
#endif

namespace core {

#ifdef __AVR__
template <class T, size_t size = sizeof(T)>
struct RomReader {
    static T read(const T& in_flash) {
        T copy;
        ROM_COPY(&copy, &in_flash, size);
        return copy;
    }
};
template <class T>
struct RomReader<T, 1> {
    static T read(const T& in_flash) { return static_cast<T>(pgm_read_byte(&in_flash)); }
};
template <>
struct RomReader<uint16_t, 2> {
    static uint16_t read(const uint16_t& in_flash) { return pgm_read_word(&in_flash); }
};
template <>
struct RomReader<int16_t, 2> {
    static int16_t read(const int16_t& in_flash) {
        return static_cast<int16_t>(pgm_read_word(&in_flash));
    }
};
template <>
struct RomReader<uint32_t, 4> {
    static uint32_t read(const uint32_t& in_flash) { return pgm_read_dword(&in_flash); }
};
template <class F>
struct RomReader<F*, 2> {
    static F* read(F* const& in_flash) { return reinterpret_cast<F*>(pgm_read_word(&in_flash)); }
};
#else
template <class T>
struct RomReader {
    static T read(const T& in_flash) { return in_flash; }
};
#endif

// Reads one object out of flash. One byte, whole numbers of two, uint32_t and pointers are plain
// loads; the rest is copied.
template <class T>
inline T romRead(const T& in_flash) {
    return RomReader<T>::read(in_flash);
}

template <class T, size_t N>
constexpr size_t count(const T (&)[N]) {
    return N;
}

}  // namespace core
