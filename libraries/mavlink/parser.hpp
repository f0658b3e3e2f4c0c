// SPDX-License-Identifier: GPL-3.0-or-later
// Frames out of a stream of bytes, MAVLink 1 and 2 mixed. The bytes of the frame under way are
// kept until its checksum has been seen: when it turns out not to have been a frame, the search
// goes on with its second byte, so that noise never costs the good frame that follows it.
#pragma once
#include <stdint.h>
#include <string.h>

#include "mavlink/frame.hpp"

namespace mavlink {

constexpr uint8_t kNoRow = 0xFF;

template <bool wide>
struct IndexType {
    using Type = uint8_t;
};
template <>
struct IndexType<true> {
    using Type = uint16_t;
};

// Table::find(uint16_t id, Accepted& to) returns the row, or kNoRow; asked once a frame.
// kCapacity: of the longest frame to be understood, header and checksum included.
template <class Table, uint16_t kCapacity>
class Parser {
    using Index = typename IndexType<(kCapacity > 255)>::Type;

public:
    // for (bool whole = parser.put(byte); whole; whole = parser.next()) use(parser.frame());
    bool put(uint8_t byte) {
        if (skip_ > 0) {
            --skip_;
            return false;
        }
        if (used_ == 0 && !isMagic(byte)) return false;
        bytes_[used_++] = byte;
        return used_ >= need_ && examine();
    }

    bool next() {
        leaveOut(static_cast<uint16_t>(need_ + signatureSize()));
        return examine();
    }

    Frame frame() const {
        Frame frame;
        const bool v1 = isV1();
        const uint8_t* sequence = bytes_ + (v1 ? 2 : 4);
        frame.framing = v1 ? Framing::v1 : Framing::v2;
        frame.payload = bytes_ + headerSize();
        frame.length = bytes_[1];
        frame.id = id();
        frame.row = row_;
        frame.sequence = sequence[0];
        frame.system = sequence[1];
        frame.component = sequence[2];
        return frame;
    }

    // Frames whose checksum was wrong, noise that looked like one included.
    uint16_t rejected() const { return rejected_; }

private:
    static bool isMagic(uint8_t byte) { return byte == kMagicV1 || byte == kMagicV2; }
    bool isV1() const { return bytes_[0] == kMagicV1; }
    uint8_t headerSize() const { return isV1() ? kHeaderV1 : kHeaderV2; }
    uint8_t signatureSize() const {
        return !isV1() && (bytes_[2] & kSignedFlag) != 0 ? kSignature : 0;
    }
    // No flag that we do not know, and no id that no dialect uses.
    bool readable() const {
        return isV1() || ((bytes_[2] & ~kSignedFlag & 0xFF) == 0 && bytes_[9] == 0);
    }
    uint16_t id() const {
        return isV1() ? bytes_[5] : static_cast<uint16_t>(bytes_[7] | (bytes_[8] << 8));
    }

    // Looks at what is kept until a whole good frame stands at its beginning, or bytes are short.
    bool examine() {
        for (;;) {
            if (!accepted_ && !seekHeader()) return false;
            if (!accepted_ && !acceptHeader()) continue;
            if (used_ < need_) return false;
            if (checksumFits()) break;
            ++rejected_;
            drop(1);
        }
        memcpy(peer_, bytes_ + (isV1() ? 3 : 5), sizeof peer_);
        return true;
    }

    bool seekHeader() {
        Index start = 0;
        while (start < used_ && !isMagic(bytes_[start])) ++start;
        if (start > 0) drop(start);
        if (used_ == 0) return false;
        need_ = headerSize();
        return used_ >= need_;
    }

    // True: row_, crc_extra_ and need_ are those of the frame that begins here. False: it was left
    // out.
    bool acceptHeader() {
        const uint8_t length = bytes_[1];
        const uint16_t size = static_cast<uint16_t>(headerSize() + length + kChecksum);
        Accepted accepted;
        const uint8_t row = readable() ? Table::find(id(), accepted) : kNoRow;
        if (row != kNoRow && size <= kCapacity && (!isV1() || length >= accepted.length)) {
            accepted_ = true;
            row_ = row;
            crc_extra_ = accepted.crc_extra;
            need_ = static_cast<Index>(size);
            return true;
        }
        // What cannot be checked is skipped whole only when it comes from who sent the last good
        // frame; else it may be noise, and its length would swallow good frames.
        const bool from_peer = readable() && peer_[0] != 0 &&
                               memcmp(peer_, bytes_ + (isV1() ? 3 : 5), sizeof peer_) == 0;
        leaveOut(from_peer ? static_cast<uint16_t>(size + signatureSize()) : 1);
        return false;
    }

    bool checksumFits() const {
        uint16_t crc =
            core::crc16(core::kCrcStart, bytes_ + 1, static_cast<uint16_t>(need_ - 1 - kChecksum));
        crc = core::crc16(crc, crc_extra_);
        return bytes_[need_ - 2] == static_cast<uint8_t>(crc) &&
               bytes_[need_ - 1] == static_cast<uint8_t>(crc >> 8);
    }

    void leaveOut(uint16_t count) {
        const Index kept = count < used_ ? static_cast<Index>(count) : used_;
        skip_ = static_cast<uint16_t>(count - kept);
        drop(kept);
    }

    void drop(Index count) {
        used_ = static_cast<Index>(used_ - count);
        memmove(bytes_, bytes_ + count, used_);
        accepted_ = false;
        need_ = kHeaderV1;
    }

    // All zero at first, so that a static parser costs no start-up code.
    uint8_t bytes_[kCapacity] = {};
    Index used_ = 0;
    Index need_ = 0;     // bytes before there is something to look at
    uint16_t skip_ = 0;  // of a frame that is left out
    uint16_t rejected_ = 0;
    uint8_t peer_[2] = {};   // system and component of the last good frame
    bool accepted_ = false;  // the header; what follows holds from then on
    uint8_t row_ = 0;
    uint8_t crc_extra_ = 0;
};

}  // namespace mavlink
