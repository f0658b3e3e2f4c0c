// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/telemetry/text.hpp"

#include "firmware/log/log.hpp"
#include "firmware/telemetry/link.hpp"
#include "firmware/telemetry/text_queue.hpp"

namespace firmware {
namespace {

struct Text {
    core::RomText text;
    int32_t number;
    Severity severity;
    uint8_t waiting;  // a bit a link, and one for the log, that has not taken it yet
};

constexpr uint8_t kTexts = 5;
constexpr uint8_t kEveryLink = (1 << kLinks) - 1;
constexpr uint8_t kLog = 1 << kLinks;
Text texts[kTexts];
uint8_t used;
uint8_t lost;

uint8_t bitOf(const Link& link) { return static_cast<uint8_t>(1 << linkNumber(link)); }

void forgetTaken() {
    const uint8_t takers = logOpen() ? kEveryLink | kLog : kEveryLink;
    while (used > 0 && (texts[0].waiting & takers) == 0) {
        --used;
        memmove(texts, texts + 1, used * sizeof texts[0]);
    }
}

uint8_t decimal(int32_t number, char (&to)[11]) {
    uint32_t rest = number < 0 ? 0 - static_cast<uint32_t>(number) : static_cast<uint32_t>(number);
    char digits[10];
    uint8_t count = 0;
    do {
        digits[count++] = static_cast<char>('0' + rest % 10);
        rest /= 10;
    } while (rest != 0);
    uint8_t length = 0;
    if (number < 0) to[length++] = '-';
    while (count > 0) to[length++] = digits[--count];
    return length;
}

void spell(const Text& from, char* to) {
    char number[11];
    uint8_t length = 0;
    for (core::RomText c = from.text; length < kTextSize; ++c) {
        const char letter = core::romRead(*c);
        if (letter == 0) break;
        if (letter != '#') {
            to[length++] = letter;
            continue;
        }
        const uint8_t digits = decimal(from.number, number);
        for (uint8_t i = 0; i < digits && length < kTextSize; ++i) to[length++] = number[i];
    }
    memset(to + length, 0, kTextSize - length);
}

}  // namespace

void tell(Severity severity, core::RomText text) { tell(severity, text, 0); }

void tell(Severity severity, core::RomText text, int32_t number) {
    if (used == kTexts) {
        if (lost < 0xFF) ++lost;
        return;
    }
    texts[used++] = {text, number, severity,
                     static_cast<uint8_t>(kEveryLink | (logOpen() ? kLog : 0))};
}

uint8_t textsLost() { return lost; }

bool textWaits(const Link& link) {
    for (uint8_t i = 0; i < used; ++i)
        if ((texts[i].waiting & bitOf(link)) != 0) return true;
    return false;
}

namespace {

// The oldest the log has not had; `used`: there is none.
uint8_t nextForLog() {
    uint8_t i = 0;
    while (i < used && (texts[i].waiting & kLog) == 0) ++i;
    return i;
}

}  // namespace

bool textWaitsForLog() { return nextForLog() < used; }

bool textForLog(char* to) {
    const uint8_t i = nextForLog();
    if (i == used) return false;
    spell(texts[i], to);
    return true;
}

void textLogged() {
    const uint8_t i = nextForLog();
    if (i == used) return;
    texts[i].waiting &= static_cast<uint8_t>(~kLog);
    forgetTaken();
}

namespace {

// Rarely gone through, and large: what asks saves no registers for it.
__attribute__((noinline)) bool sendText(Link& link) {
    if (lost > 0 && used < kTexts) {
        const uint8_t count = lost;
        lost = 0;
        tell(Severity::warning, ROM_TEXT("# texts lost"), count);
    }
    for (uint8_t i = 0; i < used; ++i) {
        if ((texts[i].waiting & bitOf(link)) == 0) continue;
        mavlink::Statustext message = {};
        message.severity = static_cast<uint8_t>(texts[i].severity);
        spell(texts[i], message.text);
        if (!send(link, message)) return false;
        texts[i].waiting &= static_cast<uint8_t>(~bitOf(link));
        forgetTaken();
        return true;
    }
    return false;
}

}  // namespace

bool textSend(Link& link) { return (used > 0 || lost > 0) && sendText(link); }

}  // namespace firmware
