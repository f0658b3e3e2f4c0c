// SPDX-License-Identifier: GPL-3.0-or-later
// A packed text as a string.
#pragma once
#include <string>

#include "firmware/notify/status_text.hpp"

inline std::string spelt(firmware::notify::StatusText text) {
    std::string letters;
    core::Unpacker from = text.letters();
    for (char letter; (letter = from.next()) != 0;) letters += letter;
    return letters;
}
