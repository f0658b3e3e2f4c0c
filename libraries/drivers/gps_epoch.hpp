// SPDX-License-Identifier: GPL-3.0-or-later
// Where the readers of all GPS protocols gather one moment's fix, part by part. One of them is
// active at a time.
#pragma once
#include <string.h>

#include "drivers/gps_fix.hpp"

namespace drivers {

struct GpsEpoch {
    static constexpr uint8_t kPosition = 1, kVelocity = 2, kUnfixed = 4, kReported = 8;

    GpsFix fix;
    uint32_t time;     // of the parts so far, as the receiver sends it
    uint16_t refused;  // whole and right messages that said what cannot be
    uint8_t parts;     // k...
    GpsFixType type;   // as last derived from the parts
    bool odd;          // a part has a value that cannot be
    bool forgot;       // the receiver does not have the settings it was given

    // A part of the epoch of `at`; false: that one was reported already.
    bool takes(uint8_t part, uint32_t at) {
        if (at != time) parts = 0;
        time = at;
        if (parts & kReported) return false;
        parts |= part;
        return true;
    }
    bool whole() const { return (parts & 3) == (kPosition | kVelocity); }
    void refuse() {
        if (++refused == 0) --refused;
    }

    // The fix is complete: of this type, if nothing about it is impossible.
    void finish(GpsFixType as);

    void setSpeed(uint32_t cms, uint32_t course_cd);
    int16_t speed(int32_t cms);
    void velocityFromCourse();  // north and east; there is no down
    // UTC as hhmmss and milliseconds, and day, month, year, both in decimal digits.
    void setUtc(uint32_t hhmmssmmm, uint32_t ddmmyy);
};

// Of a little-endian message; so is this chip.
template <class T>
T loaded(const uint8_t* at) {
    T value;
    memcpy(&value, at, sizeof value);
    return value;
}

}  // namespace drivers
