// SPDX-License-Identifier: GPL-3.0-or-later
#include "firmware/notify/status_text.hpp"

#include <string.h>

#include "core/file_state.hpp"
#include "firmware/notify/text_queue.hpp"

namespace firmware {
namespace notify {
namespace {

// What the compiler packs by, once more for reading in flight.
struct PairsInFlash {
    constexpr PairsInFlash() {
        for (size_t i = 0; i < core::count(kTextPairs); ++i) pair[i] = kTextPairs[i];
    }
    core::CodePair pair[core::count(kTextPairs)] = {};
};
constexpr PairsInFlash pairs ROM;
static_assert(core::pairsDeep(kTextPairs) <= core::kPairsDeep, "an Unpacker has no room");

struct Text {
    StatusText text;
    int32_t number;
    Severity severity;
    uint8_t waiting;  // a bit a reader that has not taken it yet
};

constexpr uint8_t kTexts = 5;
struct TextQueue {
    Text texts[kTexts];
    uint8_t used;
    uint8_t lost;
};
core::FileState<TextQueue> queue{};

// Apart from the queue, which is zeros at start and so needs no copy in flash.
struct Readers {
    uint8_t listening = kLinkReaders;
};
core::FileState<Readers> readers{};

constexpr uint8_t bitOf(uint8_t reader) { return static_cast<uint8_t>(1U << reader); }

void forgetTaken() {
    while (queue.used > 0 && (queue.texts[0].waiting & readers.listening) == 0) {
        --queue.used;
        memmove(queue.texts, queue.texts + 1, queue.used * sizeof queue.texts[0]);
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
    core::Unpacker letters = from.text.letters();
    for (char letter; length < kTextSize && (letter = letters.next()) != 0;) {
        if (letter != '#') {
            to[length++] = letter;
            continue;
        }
        const uint8_t digits = decimal(from.number, number);
        for (uint8_t i = 0; i < digits && length < kTextSize; ++i) to[length++] = number[i];
    }
    memset(to + length, 0, kTextSize - length);
}

// The oldest that the reader has not had; `used`: there is none.
uint8_t nextFor(uint8_t reader) {
    uint8_t i = 0;
    while (i < queue.used && (queue.texts[i].waiting & bitOf(reader)) == 0) ++i;
    return i;
}

void reportLost() {
    if (queue.lost == 0 || queue.used == kTexts) return;
    const uint8_t count = queue.lost;
    queue.lost = 0;
    sendStatusText(Severity::warning, STATUS_TEXT("# texts lost"), count);
}

}  // namespace

core::Unpacker StatusText::letters() const { return {codes_, 0xFF, pairs.pair}; }

void sendStatusText(Severity severity, StatusText text) { sendStatusText(severity, text, 0); }

void sendStatusText(Severity severity, StatusText text, int32_t number) {
    if (queue.used == kTexts) {
        if (queue.lost < 0xFF) ++queue.lost;
        return;
    }
    queue.texts[queue.used++] = {text, number, severity, readers.listening};
}

uint8_t textsLost() { return queue.lost; }

void setTextReader(uint8_t reader, bool listens) {
    readers.listening = static_cast<uint8_t>(listens ? readers.listening | bitOf(reader)
                                                     : readers.listening & ~bitOf(reader));
    if (!listens) forgetTaken();  // what waited for it alone
}

bool textWaits(uint8_t reader) {
    return nextFor(reader) < queue.used || (queue.lost > 0 && reader < kLogReader);
}

bool readText(uint8_t reader, Severity& severity, char* to) {
    if (reader < kLogReader) reportLost();
    const uint8_t i = nextFor(reader);
    if (i == queue.used) return false;
    severity = queue.texts[i].severity;
    spell(queue.texts[i], to);
    return true;
}

void textTaken(uint8_t reader) {
    const uint8_t i = nextFor(reader);
    if (i == queue.used) return;
    queue.texts[i].waiting &= static_cast<uint8_t>(~bitOf(reader));
    forgetTaken();
}

}  // namespace notify
}  // namespace firmware
