// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulator/report/page_bytes.hpp"

// A megabyte as an array in C++ would take the compiler a minute.
asm(".section .rodata\n"
    "page_begins: .incbin \"" PAGE_FILE
    "\"\n"
    "page_ends:\n"
    "campaign_begins: .incbin \"" CAMPAIGN_FILE
    "\"\n"
    "campaign_ends:\n"
    ".text\n");
extern const char page_begins[], page_ends[], campaign_begins[], campaign_ends[];

namespace simulator {

std::string_view flightPageTemplate() {
    return {page_begins, static_cast<size_t>(page_ends - page_begins)};
}

std::string_view campaignPageTemplate() {
    return {campaign_begins, static_cast<size_t>(campaign_ends - campaign_begins)};
}

}  // namespace simulator
