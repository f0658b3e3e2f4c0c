// SPDX-License-Identifier: GPL-3.0-or-later
// The queue is drained by EE_RDY, an interrupt that is on whenever no byte is being written.
// Reading stops it first, so that no write begins between two bytes of a reader.
#include "hal/eeprom.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "restart.hpp"
#include "start.hpp"

namespace {

constexpr uint8_t kMask = hal::kEepromQueue - 1;
static_assert((hal::kEepromQueue & kMask) == 0, "a power of two");

// Indices count on and are masked when used, so that all places can be filled.
struct {
    uint16_t addresses[hal::kEepromQueue];
    uint8_t values[hal::kEepromQueue];
    volatile uint8_t head, tail;
    uint8_t writes;  // of the byte at the tail
} queue;

// No write begins while somebody is reading, or waits to: then for so many overflows of the clock.
// Longer than the 100 ms of a task that comes ten times a second: it would be late every time.
constexpr uint8_t kPatience = 5;  // 131..164 ms
// Nor behind a byte that was written again, so that a worn cell does not keep readers waiting.
constexpr uint8_t kRest = 1;  // up to 33 ms
volatile uint8_t patience;
volatile bool reading;
uint16_t waiting_address;  // of the reader that is waited for

inline uint8_t queued() { return static_cast<uint8_t>(queue.head - queue.tail); }
inline bool writing() { return EECR & (1 << EEPE); }
inline void interruptOn() { EECR |= 1 << EERIE; }
inline void interruptOff() { EECR &= static_cast<uint8_t>(~(1 << EERIE)); }

inline uint8_t readCell(uint16_t address) {
    EEAR = address;
    EECR |= 1 << EERE;
    return EEDR;
}

bool outside(uint16_t address, uint8_t size) {
    return address > hal::kEepromSize || size > hal::kEepromSize - address;
}

class Reading {
public:
    Reading() { reading = true; }
    ~Reading() {
        reading = false;
        interruptOn();
    }
};

// What is queued lies over what was read; in queue order, so that the newest wins.
void overlay(uint16_t address, uint8_t* to, uint8_t size) {
    for (uint8_t i = queue.tail; i != queue.head; ++i) {
        const uint16_t offset = queue.addresses[i & kMask] - address;
        if (offset < size) to[offset] = queue.values[i & kMask];
    }
}

}  // namespace

// One byte a call: a byte that need not be written brings the interrupt at once again, and so does
// one that has been: it leaves the queue when it is read back.
ISR(EE_READY_vect) {
    if (reading || patience != 0 || queue.head == queue.tail || avr::supply_sags) {
        interruptOff();
        return;
    }
    const uint8_t at = queue.tail & kMask;
    const uint8_t value = queue.values[at];
    if (readCell(queue.addresses[at]) == value || queue.writes == hal::kEepromWrites) {
        queue.writes = 0;
        ++queue.tail;
        return;
    }
    if (queue.writes != 0) patience = kRest;
    ++queue.writes;
    EEDR = value;
    EECR |= 1 << EEMPE;
    EECR |= 1 << EEPE;  // within four cycles of the line above
}

namespace avr {

// The interrupt switches itself off again when there is nothing to do for it.
void eepromTick() {
    if (patience != 0) --patience;
    if (patience == 0) interruptOn();
}

}  // namespace avr

namespace hal {

core::Status eepromRead(uint16_t address, void* to, uint8_t size) {
    if (outside(address, size)) return core::Status::bad_argument;
    const Reading from_here_on;
    if (writing()) {
        if (patience == 0) {
            waiting_address = address;
            patience = kPatience;
        }
        return core::Status::busy;
    }
    uint8_t* const bytes = static_cast<uint8_t*>(to);
    for (uint8_t i = 0; i < size; ++i) bytes[i] = readCell(address + i);
    overlay(address, bytes, size);
    if (address == waiting_address) patience = 0;
    return core::Status::ok;
}

core::Status eepromWrite(uint16_t address, const void* from, uint8_t size) {
    if (outside(address, size) || size > kEepromQueue) return core::Status::bad_argument;
    if (size > kEepromQueue - queued()) return core::Status::busy;
    const uint8_t* bytes = static_cast<const uint8_t*>(from);
    for (uint8_t i = 0; i < size; ++i) {
        const uint8_t at = queue.head & kMask;
        queue.addresses[at] = address + i;
        queue.values[at] = bytes[i];
        __asm__ volatile("" ::: "memory");  // the entry before the index that hands it over
        ++queue.head;
    }
    interruptOn();
    return core::Status::ok;
}

bool eepromDrained() { return queued() == 0 && !writing(); }

}  // namespace hal
