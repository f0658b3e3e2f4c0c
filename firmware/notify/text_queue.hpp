// SPDX-License-Identifier: GPL-3.0-or-later
// The readers' side of status_text.hpp: the ground links, 0 and up, and the log. A text stays until
// every reader that listens has taken it.
#pragma once
#include <stdint.h>

#include "firmware/notify/status_text.hpp"

namespace firmware {
namespace notify {

constexpr uint8_t kLogReader = 2;    // behind the links
constexpr uint8_t kLinkReaders = 3;  // a bit a link: they always listen

void setTextReader(uint8_t reader, bool listens);

bool textWaits(uint8_t reader);
// The oldest text that the reader has not had, kTextSize characters; false: there is none. It is
// the next again until textTaken. A link is first given the number of texts lost, if any were.
bool readText(uint8_t reader, Severity& severity, char* to);
void textTaken(uint8_t reader);
uint8_t textsLost();  // not yet reported

}  // namespace notify
}  // namespace firmware
