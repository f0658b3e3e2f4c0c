// SPDX-License-Identifier: GPL-3.0-or-later
// Memory by patterns: what is written must read back. Of EEPROM only cells that the firmware's map
// leaves free, which get their old contents back; of the DataFlash only its buffers, which hold
// nothing between two writes.
#include <avr/io.h>
#include <string.h>

#include "board.hpp"
#include "drivers/at45db.hpp"
#include "hal/clock.hpp"
#include "hal/eeprom.hpp"
#include "self_test/parts.hpp"
#include "self_test/report.hpp"
#include "storage/eeprom_map.hpp"

extern uint8_t __heap_start;  // the linker's end of the variables

namespace self_test {

namespace {

constexpr uint8_t kPatterns[] = {0x00, 0xFF, 0x55, 0xAA};
constexpr uint8_t kSpareSize = static_cast<uint8_t>(storage::kSpare.size);
static_assert(storage::kSpare.size >= 4 && kSpareSize <= hal::kEepromQueue,
              "some cells are free, and are written in one piece");

void readSpare(uint8_t* to) {
    while (hal::eepromRead(storage::kSpare.begin, to, kSpareSize) == core::Status::busy) {
    }
}

void writeSpare(const uint8_t* from) {
    while (hal::eepromWrite(storage::kSpare.begin, from, kSpareSize) == core::Status::busy) {
    }
    while (!hal::eepromDrained()) {
    }
}

// Which of the cells have not kept it, a bit a cell.
uint32_t badCells(uint8_t pattern) {
    uint8_t bytes[kSpareSize];
    memset(bytes, pattern, sizeof bytes);
    writeSpare(bytes);
    readSpare(bytes);
    uint32_t bad = 0;
    for (uint8_t i = 0; i < kSpareSize; ++i)
        if (bytes[i] != pattern) bad |= 1UL << i;
    return bad;
}

uint8_t bitsOf(uint32_t set) {
    uint8_t bits = 0;
    for (; set != 0; set >>= 1) bits += set & 1;
    return bits;
}

using Dataflash = drivers::At45db<board::FlashBus, board::FlashSelect, board::FlashReset>;
Dataflash dataflash;

uint16_t clock_ms() { return static_cast<uint16_t>(hal::now_ms()); }

void startDataflash() {
    constexpr uint16_t kStarts_ms = 1000;
    dataflash.start(clock_ms());
    for (const uint32_t begin_ms = hal::now_ms();
         !dataflash.known() && hal::now_ms() - begin_ms < kStarts_ms;)
        dataflash.step(clock_ms());
}

// Data sheet 3500: 0xD4 and 0xD6 read the buffers, an address of three bytes and one to wait.
void readBuffer(uint8_t buffer, uint16_t offset, uint8_t* to, uint8_t size) {
    const uint8_t ask[] = {static_cast<uint8_t>(buffer == 0 ? 0xD4 : 0xD6), 0,
                           static_cast<uint8_t>(offset >> 8), static_cast<uint8_t>(offset), 0};
    board::FlashSelect::low();
    board::FlashBus::send(ask, sizeof ask);
    board::FlashBus::receive(to, size);
    board::FlashSelect::high();
}

// Each byte differs from its neighbours, and from what another pattern or buffer puts there.
uint8_t byteOf(uint8_t buffer, uint16_t offset, uint8_t pattern) {
    return static_cast<uint8_t>(pattern ^ (offset + (offset >> 8)) ^ (buffer << 4));
}

constexpr uint8_t kChunk = 16, kBuffers = 2;

void fillBuffer(uint8_t buffer, uint8_t pattern) {
    uint8_t bytes[kChunk];
    for (uint16_t at = 0; at < dataflash.pageSize(); at += kChunk) {
        for (uint8_t i = 0; i < kChunk; ++i) bytes[i] = byteOf(buffer, at + i, pattern);
        while (dataflash.fill(buffer, at, bytes, kChunk, clock_ms()) == core::Status::busy) {
        }
    }
}

uint16_t badBytes(uint8_t buffer, uint8_t pattern) {
    uint8_t bytes[kChunk];
    uint16_t bad = 0;
    for (uint16_t at = 0; at < dataflash.pageSize(); at += kChunk) {
        readBuffer(buffer, at, bytes, kChunk);
        for (uint8_t i = 0; i < kChunk; ++i) bad += bytes[i] != byteOf(buffer, at + i, pattern);
    }
    return bad;
}

}  // namespace

void testEeprom() {
    uint8_t before[kSpareSize];
    readSpare(before);
    uint32_t bad = 0;
    for (const uint8_t pattern : kPatterns) bad |= badCells(pattern);
    writeSpare(before);
    text(TEXT("eeprom cells "));
    number(kSpareSize);
    line(TEXT(" bad "), bitsOf(bad));
}

void testDataflash() {
    startDataflash();
    const bool works = dataflash.known() && dataflash.trouble() == drivers::At45dbTrouble::none;
    uint16_t bad = 0;
    if (works) {
        for (const uint8_t pattern : kPatterns) {
            for (uint8_t buffer = 0; buffer < kBuffers; ++buffer) fillBuffer(buffer, pattern);
            for (uint8_t buffer = 0; buffer < kBuffers; ++buffer) bad += badBytes(buffer, pattern);
        }
    }
    text(TEXT("dataflash pages "));
    number(works ? dataflash.pages() : 0);
    text(TEXT(" bytes "));
    number(works ? dataflash.pageSize() : 0);
    line(TEXT(" bad "), bad);
}

void testRam() {
    constexpr uint16_t kStack = 256;  // below what is used now: for interrupts
    constexpr uint8_t kBoth[] = {0x55, 0xAA};
    volatile uint8_t* const begin = &__heap_start;
    volatile uint8_t* const end = reinterpret_cast<volatile uint8_t*>(SP - kStack);
    uint16_t bad = 0;
    for (const uint8_t pattern : kBoth) {
        for (volatile uint8_t* at = begin; at < end; ++at)
            *at = static_cast<uint8_t>(pattern ^ reinterpret_cast<uint16_t>(at) % 251);
        for (volatile uint8_t* at = begin; at < end; ++at)
            bad += *at != static_cast<uint8_t>(pattern ^ reinterpret_cast<uint16_t>(at) % 251);
    }
    text(TEXT("ram bytes "));
    number(static_cast<uint16_t>(end - begin));
    line(TEXT(" bad "), bad);
}

}  // namespace self_test
