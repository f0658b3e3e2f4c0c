// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstring>
#include <string>

#include "firmware/notify/text_queue.hpp"
#include "firmware/safety/arming.hpp"

namespace bench {

// The text to the pilot about the first check that fails; empty: none does.
inline std::string prearmFailure() {
    using namespace firmware::notify;
    char text[kTextSize];
    Severity severity;
    const auto takeAll = [&] {
        std::string last;
        while (readText(0, severity, text)) {
            last.assign(text, strnlen(text, sizeof text));
            for (uint8_t reader : {0, 1, 2})
                if (textWaits(reader)) textTaken(reader);
        }
        return last;
    };
    takeAll();
    if (!firmware::safety::reportPrearmFailure(Severity::warning)) return {};
    return takeAll();
}

}  // namespace bench
