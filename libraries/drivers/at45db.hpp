// SPDX-License-Identifier: GPL-3.0-or-later
// Atmel AT45DB161D or AT45DB321D DataFlash (datasheets 3500 and 3597) on a bus of its own. Nothing
// waits for the chip: what it has no time for is answered busy. A chip that stays busy longer than
// the datasheet allows, or that no longer says who it is, is not used again.
#pragma once
#include <stdint.h>

#include "core/status.hpp"

namespace drivers {

enum class At45dbTrouble : uint8_t { none, absent, stuck, garbled };

// Bus::send and Bus::receive pass bytes one way, at least one; Reset is the chip's reset line.
// Times are in milliseconds and may wrap.
template <class Bus, class Select, class Reset>
class At45db {
public:
    void start(uint16_t now_ms);
    // Some times a second: takes the start further, and sees that no work takes too long.
    void step(uint16_t now_ms);

    bool known() const { return state_ >= State::ready; }
    At45dbTrouble trouble() const {
        return state_ <= State::ready
                   ? At45dbTrouble::none
                   : static_cast<At45dbTrouble>(static_cast<uint8_t>(state_) -
                                                static_cast<uint8_t>(State::ready));
    }
    uint16_t pages() const;
    uint16_t pageSize() const { return shape_ & kPagesOf512 ? 512 : 528; }
    bool busy(uint16_t now_ms) { return working(now_ms); }

    // Past the buffers. bad_argument: not all of it is in the page.
    MUST_USE core::Status read(uint16_t page, uint16_t offset, void* to, uint8_t size,
                               uint16_t now_ms);
    // Into buffer 0 or 1. busy: that one is being programmed.
    MUST_USE core::Status fill(uint8_t buffer, uint16_t offset, const void* from, uint8_t size,
                               uint16_t now_ms);
    // Erases the page and programs the buffer into it. ok: begun.
    MUST_USE core::Status store(uint8_t buffer, uint16_t page, uint16_t now_ms);
    // Erases one page, or the block of eight it is in. ok: begun.
    MUST_USE core::Status erasePage(uint16_t page, uint16_t now_ms) {
        return work(kErasePage, page, kErasePage_ms, now_ms);
    }
    MUST_USE core::Status eraseBlock(uint16_t page, uint16_t now_ms) {
        return work(kEraseBlock, page, kEraseBlock_ms, now_ms);
    }

private:
    enum class State : uint8_t { finishing, resetting, recovering, ready, absent, stuck, garbled };
    enum Opcode : uint8_t {
        kRead = 0xD2,
        kStatus = 0xD7,
        kIdentity = 0x9F,
        kErasePage = 0x81,
        kEraseBlock = 0x50,
        kFill = 0x84,   // buffer 2: 0x87
        kStore = 0x83,  // buffer 2: 0x86
        kNextBuffer = 3
    };
    // Of the status byte; datasheets, "Status register read".
    static constexpr uint8_t kReady = 0x80, kDensity = 0x3C, kPagesOf512 = 0x01;
    static constexpr uint8_t kShape = kDensity | kPagesOf512;
    static constexpr uint8_t k161d = 0x2C, k321d = 0x34;
    static constexpr uint8_t kMaker = 0x1F, kFamily161d = 0x26, kFamily321d = 0x27;
    static constexpr uint8_t kAddress = 4, kAddressForRead = 8;  // opcode and what follows it
    // Datasheets, "AC characteristics", the longest tEP, tPE, tBE.
    static constexpr uint8_t kStore_ms = 40, kErasePage_ms = 35, kEraseBlock_ms = 100;

    static void command(uint8_t opcode, uint8_t size, uint16_t page_bits, uint16_t offset);
    static void ask(uint8_t opcode, uint8_t* answer, uint8_t size) {
        Select::low();
        Bus::send(&opcode, 1);
        Bus::receive(answer, size);
        Select::high();
    }
    static uint8_t status();
    void identify();
    bool inTime(uint16_t now_ms, uint8_t longest_ms) const {
        // its clock ticks somewhere within the first millisecond
        return static_cast<uint16_t>(now_ms - since_ms_) <= longest_ms + 1u;
    }
    bool working(uint16_t now_ms);
    core::Status idle(uint16_t now_ms);
    core::Status usable() const;
    core::Status work(uint8_t opcode, uint16_t page, uint8_t longest_ms, uint16_t now_ms);
    bool inPage(uint16_t offset, uint8_t size) const {
        return size > 0 && offset < pageSize() && size <= pageSize() - offset;
    }
    uint16_t pageBits(uint16_t page) const { return page << (shape_ & kPagesOf512 ? 1 : 2); }

    uint16_t since_ms_ = 0;   // the state was entered, or the work under way begun
    uint8_t longest_ms_ = 0;  // of the work under way; 0: none
    uint8_t at_work_ = 0;     // opcode of the work last begun
    uint8_t shape_ = 0;       // density and page size as the status byte has them
    State state_ = State::finishing;
};

// The page's bits stand above the offset's, of which there are 9 or 10.
template <class Bus, class Select, class Reset>
void At45db<Bus, Select, Reset>::command(uint8_t opcode, uint8_t size, uint16_t page_bits,
                                         uint16_t offset) {
    const uint8_t bytes[kAddressForRead] = {opcode, static_cast<uint8_t>(page_bits >> 8),
                                            static_cast<uint8_t>(page_bits | offset >> 8),
                                            static_cast<uint8_t>(offset)};
    Select::low();
    Bus::send(bytes, size);
}

template <class Bus, class Select, class Reset>
uint8_t At45db<Bus, Select, Reset>::status() {
    uint8_t status;
    ask(kStatus, &status, 1);
    return status;
}

// A restart of the processor alone may find the chip programming: that page must not be damaged
// by the reset, so it is let finish.
template <class Bus, class Select, class Reset>
void At45db<Bus, Select, Reset>::start(uint16_t now_ms) {
    Select::high();
    Select::output();
    Reset::high();
    Reset::output();
    state_ = State::finishing;
    longest_ms_ = 0;
    since_ms_ = now_ms;
    step(now_ms);
}

template <class Bus, class Select, class Reset>
void At45db<Bus, Select, Reset>::step(uint16_t now_ms) {
    switch (state_) {
        case State::finishing:
            if (!(status() & kReady) && inTime(now_ms, kEraseBlock_ms)) return;
            Reset::low();
            since_ms_ = now_ms;
            state_ = State::resetting;
            return;
        case State::resetting:
            if (inTime(now_ms, 1)) return;  // 10 us, tRST; the first tick may come at once
            Reset::high();
            state_ = State::recovering;  // 1 us, tREC; the next step is later than that
            return;
        case State::recovering:
            return identify();
        default:
            working(now_ms);
    }
}

template <class Bus, class Select, class Reset>
void At45db<Bus, Select, Reset>::identify() {
    uint8_t identity[2];
    ask(kIdentity, identity, sizeof identity);
    shape_ = status() & kShape;
    const uint8_t density = identity[1] == kFamily161d   ? k161d
                            : identity[1] == kFamily321d ? k321d
                                                         : kReady;
    state_ = identity[0] == kMaker && (shape_ & kDensity) == density ? State::ready : State::absent;
}

template <class Bus, class Select, class Reset>
uint16_t At45db<Bus, Select, Reset>::pages() const {
    if (state_ != State::ready) return 0;
    return (shape_ & kDensity) == k161d ? 4096 : 8192;
}

template <class Bus, class Select, class Reset>
bool At45db<Bus, Select, Reset>::working(uint16_t now_ms) {
    if (longest_ms_ == 0) return false;
    const uint8_t now = status();
    const bool itself = (now & kShape) == shape_;
    if (itself && !(now & kReady) && inTime(now_ms, longest_ms_)) return true;
    if (!itself) state_ = State::garbled;
    if (itself && !(now & kReady)) state_ = State::stuck;
    longest_ms_ = 0;
    return false;
}

template <class Bus, class Select, class Reset>
core::Status At45db<Bus, Select, Reset>::usable() const {
    if (!known()) return core::Status::busy;
    return state_ == State::ready ? core::Status::ok : core::Status::unsupported;
}

template <class Bus, class Select, class Reset>
core::Status At45db<Bus, Select, Reset>::idle(uint16_t now_ms) {
    return working(now_ms) ? core::Status::busy : usable();
}

template <class Bus, class Select, class Reset>
core::Status At45db<Bus, Select, Reset>::read(uint16_t page, uint16_t offset, void* to,
                                              uint8_t size, uint16_t now_ms) {
    core::Status status = usable();
    if (status != core::Status::ok) return status;
    if (page >= pages() || !inPage(offset, size)) return core::Status::bad_argument;
    status = idle(now_ms);
    if (status != core::Status::ok) return status;
    command(kRead, kAddressForRead, pageBits(page), offset);
    Bus::receive(static_cast<uint8_t*>(to), size);
    Select::high();
    return core::Status::ok;
}

template <class Bus, class Select, class Reset>
core::Status At45db<Bus, Select, Reset>::fill(uint8_t buffer, uint16_t offset, const void* from,
                                              uint8_t size, uint16_t now_ms) {
    core::Status status = usable();
    if (status != core::Status::ok) return status;
    if (buffer > 1 || !inPage(offset, size)) return core::Status::bad_argument;
    const uint8_t second = buffer ? kNextBuffer : 0;
    if (at_work_ == kStore + second) status = idle(now_ms);
    if (status != core::Status::ok) return status;
    command(kFill + second, kAddress, 0, offset);
    Bus::send(static_cast<const uint8_t*>(from), size);
    Select::high();
    return core::Status::ok;
}

template <class Bus, class Select, class Reset>
core::Status At45db<Bus, Select, Reset>::store(uint8_t buffer, uint16_t page, uint16_t now_ms) {
    if (buffer > 1) return core::Status::bad_argument;
    return work(kStore + (buffer ? kNextBuffer : 0), page, kStore_ms, now_ms);
}

template <class Bus, class Select, class Reset>
core::Status At45db<Bus, Select, Reset>::work(uint8_t opcode, uint16_t page, uint8_t longest_ms,
                                              uint16_t now_ms) {
    core::Status status = usable();
    if (status != core::Status::ok) return status;
    if (page >= pages()) return core::Status::bad_argument;
    status = idle(now_ms);
    if (status != core::Status::ok) return status;
    command(opcode, kAddress, pageBits(page), 0);
    Select::high();
    at_work_ = opcode;
    longest_ms_ = longest_ms;
    since_ms_ = now_ms;
    return core::Status::ok;
}

}  // namespace drivers
