// SPDX-License-Identifier: GPL-3.0-or-later
// A byte queue between one producer and one consumer, one of them an interrupt. The indices are
// single bytes, so each side reads the other's without a lock: 38 cycles a put on this chip.
#pragma once
#include <stdint.h>
#include <string.h>

namespace core {

// Holds size - 1 bytes; size is a power of two up to 256.
template <uint16_t size>
class Ring {
    static_assert(size >= 2 && size <= 256 && (size & (size - 1)) == 0, "a power of two to 256");

public:
    bool put(uint8_t byte) {
        const uint8_t head = head_;
        const uint8_t next = (head + 1) & kMask;
        if (next == seen(tail_)) return false;
        bytes_[head] = byte;
        hand(head_, next);
        return true;
    }
    // All of them or none.
    bool put(const void* bytes, uint8_t count) {
        if (room() < count) return false;
        const uint8_t* from = static_cast<const uint8_t*>(bytes);
        const uint8_t run = runFrom(head_, count);
        memcpy(bytes_ + head_, from, run);
        memcpy(bytes_, from + run, static_cast<uint8_t>(count - run));
        handOver(index(static_cast<uint8_t>(head_ + count)));
        return true;
    }
    // The same by hand, where there is room: from the head on, and at begin() again after the end;
    // then all of it is handed over.
    uint8_t head() const { return head_; }
    uint8_t tail() const { return seen(tail_); }
    uint8_t* begin() { return bytes_; }
    static uint8_t index(uint8_t at) { return at & kMask; }
    // How many of `count` bytes from an index on lie side by side.
    static uint8_t runFrom(uint8_t at, uint8_t count) {
        const uint8_t to_last = static_cast<uint8_t>(size - 1 - at);
        return to_last < count ? static_cast<uint8_t>(to_last + 1) : count;
    }
    void handOver(uint8_t to) { hand(head_, to); }

    bool take(uint8_t& byte) {
        const uint8_t tail = tail_;
        if (tail == seen(head_)) return false;
        byte = bytes_[tail];
        hand(tail_, (tail + 1) & kMask);
        return true;
    }
    uint8_t used() const { return (seen(head_) - seen(tail_)) & kMask; }
    uint8_t room() const { return kMask - used(); }
    bool empty() const { return seen(head_) == seen(tail_); }
    void clear() { tail_ = seen(head_); }  // the consumer's to call

    // Where an interrupt in assembler finds the indices; the bytes come first.
    static constexpr uint16_t kHeadAt = size;
    static constexpr uint16_t kTailAt = size + 1;

private:
    static constexpr uint8_t kMask = static_cast<uint8_t>(size - 1);

    // The other side's index, read anew; and one's own, which hands the bytes before it over. Not
    // volatile members: those would make a constructor that runs at start.
    static uint8_t seen(const uint8_t& index) { return const_cast<const volatile uint8_t&>(index); }
    static void hand(uint8_t& index, uint8_t value) {
        __asm__ volatile("" ::: "memory");
        const_cast<volatile uint8_t&>(index) = value;
    }

    uint8_t bytes_[size] = {};
    uint8_t head_ = 0;
    uint8_t tail_ = 0;
};

}  // namespace core
