// SPDX-License-Identifier: GPL-3.0-or-later
// The receiver's channels from one train of pulses: a channel's width is the time from one rising
// edge to the next, and a gap of more than 4 ms begins a new frame. What lies between the longest
// pulse and that is two channels whose edge was missed: it must not begin a frame in the middle of
// another, in which the throttle would be a switch.
// One edge too many or too few moves the channels behind it to their neighbours' places. It shows
// at the next gap only, by the number of pulses, and sticks cannot wait for that: they are read
// from the newest frame, switches from the newest whole one.
#pragma once
#include <stdint.h>

namespace drivers {

// Everything is inlined: with a call in it an interrupt saves every register.
#define PPM_INLINE inline __attribute__((always_inline))

class PpmFrames {
public:
    static constexpr uint8_t kChannels = 8;

    PPM_INLINE void reset() {
        channel_ = kNoise;
        whole_ = kNone;
        whole_new_ = false;
        usual_ = 0;
    }

    // A rising edge, this long after the one before in steps of 0.5 us; too_long: longer than the
    // 16 bits hold. True: a frame is complete.
    PPM_INLINE bool edge(uint16_t width, bool too_long) {
        if (too_long || width > kGap) return gap();
        if (pulses_ != UINT8_MAX) ++pulses_;
        return pulse(width);
    }

    // 0.5 us steps; 0: the frame did not have the channel.
    PPM_INLINE const uint16_t* newest() const { return frames_ + newest_; }
    // The newest frame with as many pulses as its transmitter usually sends; null: none since it
    // was last taken.
    PPM_INLINE const uint16_t* takeWhole() {
        if (!whole_new_) return nullptr;
        whole_new_ = false;
        return frames_ + whole_;
    }

private:
    static constexpr uint16_t kGap = 2 * 4000;
    static constexpr uint16_t kShortest = 2 * 700;  // encoders send 900..2100 us; else it is noise
    static constexpr uint16_t kLongest = 2 * 2500;
    static constexpr uint8_t kFewestChannels = 5;
    // Frames with another number, more than there are as usual: a second.
    static constexpr uint8_t kOthersMakeUsual = 40;
    static constexpr uint8_t kComplete = 0xFE, kNoise = 0xFF;  // for channel_, until the next gap
    static constexpr uint8_t kNone = 0xFF;                     // for whole_

    PPM_INLINE void accept() {
        newest_ = filling_;
        if (whole_ == newest_ || whole_ == kNone) {
            filling_ = newest_ == 0 ? kChannels : 0;
        } else {
            filling_ = static_cast<uint8_t>(3 * kChannels - newest_ - whole_);  // the third
        }
        channel_ = kComplete;
    }

    PPM_INLINE bool gap() {
        const bool ended = channel_ >= kFewestChannels && channel_ < kComplete;
        if (ended) {
            while (channel_ < kChannels) next() = 0;
            accept();
        }
        if (channel_ == kComplete && asUsual()) {
            whole_ = newest_;
            whole_new_ = true;
        }
        channel_ = pulses_ = 0;
        return ended;
    }

    PPM_INLINE bool asUsual() {
        if (pulses_ == usual_) {
            if (others_ != 0) --others_;
        } else if (pulses_ == other_) {
            ++others_;
        } else if (others_ != 0) {
            --others_;
        } else {
            other_ = pulses_;
        }
        if (usual_ == 0 || others_ >= kOthersMakeUsual) {
            usual_ = pulses_;
            others_ = 0;
        }
        return pulses_ == usual_;
    }

    PPM_INLINE bool pulse(uint16_t width) {
        if (channel_ >= kComplete) return false;
        if (width < kShortest || width > kLongest) {
            channel_ = kNoise;
            return false;
        }
        next() = width;
        if (channel_ != kChannels) return false;
        accept();
        return true;
    }

    PPM_INLINE uint16_t& next() { return frames_[static_cast<uint8_t>(filling_ + channel_++)]; }

    uint16_t frames_[3 * kChannels];
    uint8_t newest_, whole_, filling_;  // where each begins there, so that nothing multiplies
    bool whole_new_;
    uint8_t channel_;         // the next to come
    uint8_t pulses_;          // since the gap, those behind the eighth too
    uint8_t usual_;           // number of pulses; 0: nothing received yet
    uint8_t other_, others_;  // another number, and how often more than any else
};

#undef PPM_INLINE

}  // namespace drivers
