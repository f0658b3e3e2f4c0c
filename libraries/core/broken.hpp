// SPDX-License-Identifier: GPL-3.0-or-later
// For what can not be: counts it, remembers which it was last, and leaves it to the caller to fly
// on with a safe value. The flight program informs the pilot and the log.
#pragma once
#include <stdint.h>

#include "core/file_state.hpp"

namespace core {

enum class Fault : uint8_t { none, attitude_matrix };

struct Broken {
    Fault last;
    uint8_t count;
};

template <class = void>
struct BrokenSoFar {
    static FileState<Broken> is;
};
template <class Any>
FileState<Broken> BrokenSoFar<Any>::is{};

inline const Broken& brokenSoFar() { return BrokenSoFar<>::is; }

inline void broken(Fault fault) {
    Broken& is = BrokenSoFar<>::is;
    is.last = fault;
    if (is.count != 0xFF) ++is.count;
}

}  // namespace core
