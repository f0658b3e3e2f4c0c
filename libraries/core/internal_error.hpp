// SPDX-License-Identifier: GPL-3.0-or-later
// What cannot be, and is: counted, with the line that saw it, and left to the caller to go on from
// in a defined state. The flight program informs the pilot and the log, and refuses to arm. As
// ArduPilot's AP_InternalError.
#pragma once
#include <stdint.h>

#include "core/file_state.hpp"

namespace core {

// The numbers are those of the texts and the log: docs/failsafes.md.
enum class InternalError : uint8_t {
    none,
    attitude_matrix,      // no rotation any more: the attitude begins again
    height_not_finite,    // begins again at the barometer's or the receiver's
    position_not_finite,  // begins again with the next fix
    count
};

struct InternalErrors {
    InternalError last;
    uint8_t times[static_cast<uint8_t>(InternalError::count)];  // no further than 255
    uint8_t changes;                                            // of this struct; wraps
    uint16_t line;                                              // of the source that saw the last
};

template <class = void>
struct InternalErrorsSoFar {
    static FileState<InternalErrors> are;
};
template <class Any>
FileState<InternalErrors> InternalErrorsSoFar<Any>::are{};

inline const InternalErrors& internalErrors() { return InternalErrorsSoFar<>::are; }

// Returns what it is given, for "if (!check(...))".
inline bool check(bool holds, InternalError error, uint16_t line) {
    if (holds) return true;
    InternalErrors& are = InternalErrorsSoFar<>::are;
    uint8_t& times = are.times[static_cast<uint8_t>(error)];
    if (times != 0xFF) ++times;
    are.last = error;
    are.line = line;
    ++are.changes;
    return false;
}

}  // namespace core
