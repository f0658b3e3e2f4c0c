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
        if (used_ == 0 && !isMagic(byte)) {
            if (signature_ > 0) --signature_;
            return false;
        }
        bytes_[used_++] = byte;
        return used_ >= need_ && examine();
    }

    bool next() {
        leaveOut();
        return examine();
    }

    // When the line has been silent for longer than a frame may be torn: what is kept is the
    // beginning of none. True: a whole frame stood behind it, which must not wait for the bytes of
    // another.
    bool giveUp() {
        signature_ = 0;
        while (used_ > 0) {
            ++rejected_;
            drop(1);
            if (examine()) return true;
        }
        return false;
    }
    bool waits() const { return used_ > 0; }  // for the rest of what may be a frame

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

    // For who checks the signature of the frame that is held: its bytes come behind the frame, some
    // of them may be here already. Once they are taken, none are left out behind the frame.
    bool isSigned() const { return signatureSize() > 0; }
    bool takeBehind(uint8_t& byte) {
        if (used_ <= need_) return false;
        byte = bytes_[need_];
        --used_;
        memmove(bytes_ + need_, bytes_ + need_ + 1, used_ - need_);
        return true;
    }
    void forgetSignature() { bytes_[2] &= static_cast<uint8_t>(~kSignedFlag); }

    // Frames whose checksum was wrong, noise that looked like one included.
    uint16_t rejected() const { return rejected_; }

private:
    static bool isMagic(uint8_t byte) { return byte == kMagicV1 || byte == kMagicV2; }
    bool isV1() const { return bytes_[0] == kMagicV1; }
    uint8_t headerSize() const { return isV1() ? kHeaderV1 : kHeaderV2; }
    uint8_t signatureSize() const {
        return !isV1() && (bytes_[2] & kSignedFlag) != 0 ? kSignature : 0;
    }
    // What an incompatibility flag that we do not know makes of a frame, we cannot know.
    bool compatible() const { return isV1() || (bytes_[2] & ~kSignedFlag & 0xFF) == 0; }
    const uint8_t* address() const { return bytes_ + (isV1() ? 3 : 5); }
    bool fromPeer() const { return memcmp(peer_, address(), sizeof peer_) == 0; }
    uint16_t id() const {
        return isV1() ? bytes_[5] : static_cast<uint16_t>(bytes_[7] | (bytes_[8] << 8));
    }

    // Looks at what is kept until a whole good frame stands at its beginning, or bytes are short.
    // Never inlined: put() would save its registers for every byte, 150 cycles instead of 100.
    __attribute__((noinline)) bool examine() {
        for (;;) {
            if (!measured_ && !seekHeader()) return false;
            if (!measured_ && !measure()) {
                drop(1);
                continue;
            }
            if (used_ < need_) return false;
            if (row_ == kNoRow ? !someSeedFits() : checksum(crc_extra_) != received()) {
                ++rejected_;
                drop(1);
            } else if (row_ != kNoRow && compatible()) {
                memcpy(peer_, address(), sizeof peer_);
                return true;
            } else {
                leaveOut();
            }
        }
    }

    bool seekHeader() {
        Index start = 0;
        while (start < used_ && !isMagic(bytes_[start])) ++start;
        if (start > 0) drop(start);
        if (used_ == 0) return false;
        need_ = headerSize();
        return used_ >= need_;
    }

    // True: need_, row_ and crc_extra_ are those of the frame that may begin here. False: it could
    // not be kept until its checksum, or is taken for noise.
    bool measure() {
        const uint8_t length = bytes_[1];
        const uint16_t size = static_cast<uint16_t>(headerSize() + length + kChecksum);
        if (size > kCapacity) return false;
        Accepted accepted = {0, 0, 0};
        // no dialect uses an id of more than 16 bits
        row_ = isV1() || bytes_[9] == 0 ? Table::find(id(), accepted) : kNoRow;
        if (row_ == kNoRow ? !fromPeer() : isV1() && length < accepted.length) return false;
        // a signature is as good as noise; only its sender's next frame can show that it was cut
        if (signature_ > 0 && !(fromPeer() && compatible())) return false;
        crc_extra_ = accepted.crc_extra;
        measured_ = true;
        need_ = static_cast<Index>(size);
        return true;
    }

    uint16_t received() const {
        return static_cast<uint16_t>(bytes_[need_ - 2] | bytes_[need_ - 1] << 8);
    }
    uint16_t checksum(uint8_t crc_extra) const {
        const uint16_t crc =
            core::crc16(core::kCrcStart, bytes_ + 1, static_cast<uint16_t>(need_ - 1 - kChecksum));
        return core::crc16(crc, crc_extra);
    }

    // For a message we do not know, whose seed we do not know either. But a seed is 8 bits and a
    // checksum 16: one in 256 can have been made with any seed at all. A frame whose checksum can
    // is left out whole: what its payload carries is not meant for us.
    bool someSeedFits() const {
        // a seed enters the last step of the checksum alone, and that is linear: its trace in the
        // high byte gives away what it must have done to the low one (t as in core::crc16)
        const uint16_t trace = checksum(0) ^ received();
        const uint8_t high = static_cast<uint8_t>(trace >> 8);
        const uint8_t t = static_cast<uint8_t>(high ^ high >> 5);
        const uint8_t low = static_cast<uint8_t>(static_cast<uint8_t>(t << 3) ^ t >> 4);
        return low == static_cast<uint8_t>(trace);
    }

    void leaveOut() {
        const uint8_t signature = signatureSize();
        drop(need_);
        signature_ = signature;
    }

    void drop(Index count) {
        used_ = static_cast<Index>(used_ - count);
        memmove(bytes_, bytes_ + count, used_);
        signature_ = count < signature_ ? static_cast<uint8_t>(signature_ - count) : 0;
        measured_ = false;
        need_ = kHeaderV1;
    }

    // All zero at first, so that a static parser costs no start-up code.
    uint8_t bytes_[kCapacity] = {};
    Index used_ = 0;
    Index need_ = 0;  // bytes before there is something to look at
    uint16_t rejected_ = 0;
    uint8_t peer_[2] = {};   // system and component of the last good frame
    uint8_t signature_ = 0;  // bytes of its signature that are still to come
    bool measured_ = false;  // the header has been read; what follows holds from then on
    uint8_t row_ = 0;
    uint8_t crc_extra_ = 0;
};

}  // namespace mavlink
