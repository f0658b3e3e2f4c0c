// SPDX-License-Identifier: GPL-3.0-or-later
// Texts that lie packed in flash: about half the bytes of the same texts in letters. Pairs of
// letters that are frequent have a code of their own, and so have pairs of such codes (byte pair
// encoding: Gage, "A New Algorithm for Data Compression", 1994). The compiler packs; what reads
// them is an Unpacker. The pairs come from toolchain/texts.
#pragma once
#include <stddef.h>
#include <stdint.h>

#include "core/rom.hpp"

namespace core {

constexpr uint8_t kFirstPair = 0x80;  // a code below is a letter, 0 the end
constexpr uint8_t kPairsDeep = 8;     // pairs in pairs in pairs: what an Unpacker has room for

// What code kFirstPair + i stands for. Each is a letter or an earlier pair.
struct CodePair {
    uint8_t first, second;
};

// The pairs by their first code, so that a text is looked through for those alone that may stand in
// it. Places count from one, zero is none.
template <size_t kPairs>
struct PairIndex {
    constexpr explicit PairIndex(const CodePair (&pairs)[kPairs]) {
        for (size_t place = kPairs; place > 0; --place) {
            const CodePair pair = pairs[place - 1];
            second[place] = pair.second;
            next[place] = begin[pair.first];
            begin[pair.first] = static_cast<uint8_t>(place);
        }
    }

    uint8_t begin[256] = {};  // the first pair with this first code
    uint8_t next[kPairs + 1] = {};
    uint8_t second[kPairs + 1] = {};
};

// The codes of a text of N letters at most. Compile time only; a longer text does not compile.
template <size_t N>
struct Packing {
    // The index as a copy: avr-gcc reads one faster than what a reference leads to.
    template <size_t kPairs>
    constexpr Packing(const char* text, PairIndex<kPairs> pairs) {
        for (; text[size] != 0; ++size) codes[size] = static_cast<uint8_t>(text[size]);
        while (joinFirst(pairs)) {
        }
    }
    template <size_t kPairs>
    constexpr Packing(const char* text, const CodePair (&pairs)[kPairs])
        : Packing(text, PairIndex<kPairs>(pairs)) {}

    uint8_t codes[N] = {};  // zeros behind
    size_t size = 0;

private:
    // A pair is made of earlier ones, so joining one brings only later ones into the text. The
    // compilers count their steps (clang 1,048,576 for a table), and avr-gcc keeps what each took.
    template <size_t kPairs>
    constexpr bool joinFirst(const PairIndex<kPairs>& pairs) {
        size_t place = kPairs + 1, at = 0;
        for (size_t i = 0; i + 1 < size; ++i) {
            size_t found = pairs.begin[codes[i]];
            while (found != 0 && pairs.second[found] != codes[i + 1]) found = pairs.next[found];
            if (found == 0 || found >= place) continue;
            place = found;
            at = i;
        }
        if (place > kPairs) return false;
        join(at, static_cast<uint8_t>(kFirstPair + place - 1));
        return true;
    }

    // Joins all that are the same as the two codes at `kept`, the first of them.
    constexpr void join(size_t kept, uint8_t code) {
        const uint8_t first = codes[kept], second = codes[kept + 1];
        for (size_t i = kept; i < size; ++i) {
            const bool is = i + 1 < size && codes[i] == first && codes[i + 1] == second;
            codes[kept++] = is ? code : codes[i];
            if (is) ++i;
        }
        for (size_t i = kept; i < size; ++i) codes[i] = 0;
        size = kept;
    }
};

// Not defined: where the compiler would have to call it the text is too long.
void packedTextIsTooLong();

// For ROM, with its end. A text of as many codes or more does not compile.
template <size_t kSize>
struct PackedText {
    constexpr PackedText() = default;
    template <size_t N>
    constexpr explicit PackedText(const Packing<N>& from) {
        if (from.size >= kSize) packedTextIsTooLong();
        for (size_t i = 0; i < from.size; ++i) codes[i] = from.codes[i];
    }
    uint8_t codes[kSize] = {};
};

template <size_t N, size_t kPairs>
constexpr size_t packedSize(const char (&text)[N], const CodePair (&pairs)[kPairs]) {
    return Packing<N>(text, pairs).size;
}

// The codes of all texts of a list with their ends together, to declare the PackedList.
template <size_t N, size_t kSize, size_t kPairs>
constexpr size_t listCodes(const char (&texts)[N][kSize], const CodePair (&pairs)[kPairs]) {
    const PairIndex<kPairs> index(pairs);
    size_t codes = 0;
    for (size_t i = 0; i < N; ++i) codes += Packing<kSize>(texts[i], index).size + 1;
    return codes;
}

// For ROM: texts one behind the other, each with its end.
template <size_t kCodes>
struct PackedList {
    template <size_t N, size_t kSize, size_t kPairs>
    constexpr PackedList(const char (&texts)[N][kSize], const CodePair (&pairs)[kPairs]) {
        const PairIndex<kPairs> index(pairs);
        size_t at = 0;
        for (size_t i = 0; i < N; ++i) {
            const Packing<kSize> packed(texts[i], index);
            for (size_t j = 0; j < packed.size; ++j) codes[at++] = packed.codes[j];
            ++at;  // a zero
        }
    }
    uint8_t codes[kCodes] = {};
};

// Where a text of such a list begins.
inline const uint8_t* textOfList(const uint8_t* codes, uint8_t number) {
    for (; number > 0; --number)
        while (romRead(*codes++) != 0) {
        }
    return codes;
}

// How many codes wait at most while a text is unpacked.
template <size_t kPairs>
constexpr uint8_t pairsDeep(const CodePair (&pairs)[kPairs]) {
    uint8_t deep[kPairs] = {}, deepest = 0;
    for (size_t i = 0; i < kPairs; ++i) {
        const uint8_t first = pairs[i].first, second = pairs[i].second;
        const uint8_t in_first = first < kFirstPair ? 0 : deep[first - kFirstPair];
        const uint8_t in_second = second < kFirstPair ? 0 : deep[second - kFirstPair];
        // the second waits while the first is spelt
        deep[i] = static_cast<uint8_t>(in_first + 1 > in_second ? in_first + 1 : in_second);
        if (deep[i] > deepest) deepest = deep[i];
    }
    return deepest;
}

// Spells codes out of flash, a letter at a time.
class Unpacker {
public:
    // Both lie in flash; no more than kPairsDeep deep. Ends behind `size` codes or at a zero.
    Unpacker(const uint8_t* codes, uint8_t size, const CodePair* pairs)
        : codes_(codes), pairs_(pairs), left_(size), waiting_count_(0) {}

    // 0: the end, and then again.
    char next() {
        uint8_t code = 0;
        if (waiting_count_ > 0) {
            code = waiting_[--waiting_count_];
        } else if (left_ > 0 && (code = romRead(*codes_)) != 0) {
            ++codes_;
            --left_;
        }
        while (code >= kFirstPair) {
            const CodePair& pair = pairs_[code - kFirstPair];
            waiting_[waiting_count_++] = romRead(pair.second);
            code = romRead(pair.first);
        }
        return static_cast<char>(code);
    }

private:
    const uint8_t* codes_;
    const CodePair* pairs_;
    uint8_t left_, waiting_count_;
    uint8_t waiting_[kPairsDeep];
};

// The letter that a code's text begins with.
inline char firstLetter(uint8_t code, const CodePair* pairs) {
    while (code >= kFirstPair) code = romRead(pairs[code - kFirstPair].first);
    return static_cast<char>(code);
}

// Spells into `to`, at most `size` letters, zeros behind (MAVLink's char arrays need no terminator
// when full). Returns the letters.
inline uint8_t unpack(Unpacker from, char* to, uint8_t size) {
    uint8_t length = 0;
    for (char letter; length < size && (letter = from.next()) != 0; ++length) to[length] = letter;
    for (uint8_t i = length; i < size; ++i) to[i] = 0;
    return length;
}

}  // namespace core
