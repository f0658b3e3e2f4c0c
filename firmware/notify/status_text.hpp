// SPDX-License-Identifier: GPL-3.0-or-later
// Texts for the pilot (STATUSTEXT). They wait in a short queue until every link has taken them;
// a text that finds the queue full is counted, and the count is reported when there is room again.
#pragma once
#include <stdint.h>

#include "core/packed_text.hpp"
#include "firmware/notify/text_pairs.hpp"

namespace firmware {
namespace notify {

enum class Severity : uint8_t { emergency, alert, critical, error, warning, notice, info, debug };

constexpr uint8_t kTextSize = 50;  // of STATUSTEXT

// A text of a table's row in flash. Too long a one does not compile.
template <size_t kCodes>
struct TextField {
    constexpr TextField(const char* text) : packed(core::Packing<kTextSize>(text, kTextPairs)) {}
    core::PackedText<kCodes + 1> packed;
};

// A text that lies packed in flash.
class StatusText {
public:
    StatusText() = default;  // none
    explicit StatusText(const uint8_t* codes) : codes_(codes) {}
    template <size_t kCodes>
    StatusText(const TextField<kCodes>& in_flash) : codes_(in_flash.packed.codes) {}

    bool isNone() const { return codes_ == nullptr; }
    bool isEmpty() const { return core::romRead(*codes_) == 0; }
    core::Unpacker letters() const;

private:
    const uint8_t* codes_ = nullptr;
};

// STATUS_TEXT("..."), inside a function.
#define STATUS_TEXT(text)                                                 \
    ([]() -> ::firmware::notify::StatusText {                             \
        static constexpr ::core::PackedText<                              \
            ::core::packedSize(text, ::firmware::notify::kTextPairs) + 1> \
            packed ROM(::core::Packing<::firmware::notify::kTextSize>(    \
                text, ::firmware::notify::kTextPairs));                   \
        return ::firmware::notify::StatusText(packed.codes);              \
    }())

// `number` takes the place of the text's '#'.
void sendStatusText(Severity severity, StatusText text);
void sendStatusText(Severity severity, StatusText text, int32_t number);

}  // namespace notify
}  // namespace firmware
